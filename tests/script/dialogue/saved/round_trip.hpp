// A part written and read back, for the tests of this folder and of parts.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "runtime/base/bytes.hpp"
#include "script/dialogue/saved/reader.hpp"
#include "script/dialogue/saved/writer.hpp"
#include "script/values/objects.hpp"

namespace parlour::dialogue {

// One topic with two slots, one state, one handler, one variable.
inline std::shared_ptr<const script::Program> small_program() {
  auto program = std::make_shared<script::Program>();
  program->pool = std::make_shared<script::ConstantPool>();
  program->topics.resize(1);
  program->topics[0].slots.resize(2);
  program->states.resize(1);
  program->states[0].messages.resize(2);
  program->handlers.resize(1);
  program->handlers[0].reactions.resize(1);
  return program;
}

template <class Part>
std::string bytes_of(const std::shared_ptr<const script::Program>& program,
                     const Part& part) {
  Writer writer(*program);
  writer.write(part);
  return writer.finish(script::Interpreter(program));
}

template <class Part>
Expected<void> read(const std::shared_ptr<const script::Program>& program,
                    Part& part, std::string_view bytes) {
  script::Interpreter interpreter(program);
  Reader reader(program, bytes);
  reader.begin(interpreter);
  reader(part);
  return reader.finish();
}

// Part has nothing but defaults before. The same bytes come of it.
template <class Part>
Part round_trip(const Part& part) {
  const auto program = small_program();
  const auto bytes = bytes_of(program, part);
  Part again;
  const auto done = read(program, again, bytes);
  EXPECT_TRUE(done) << done.error().message;
  EXPECT_EQ(bytes_of(program, again), bytes);
  return again;
}

} // namespace parlour::dialogue
