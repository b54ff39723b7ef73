#include "script/dialogue/inputs/replay.hpp"

#include <utility>

#include "script/dialogue/saved/reader.hpp"
#include "script/dialogue/saved/writer.hpp"

namespace parlour::dialogue {

namespace {

template <class Part>
std::string part_to_bytes(const script::Program& program, const Part& part) {
  Writer writer(program);
  writer.write(part);
  return writer.take();
}

// Nothing may be left over: bytes of another form would else pass.
template <class Part>
Expected<Part> read_part(std::shared_ptr<const script::Program> program,
                         std::string_view bytes) {
  Reader reader(std::move(program), bytes);
  Part part;
  reader(part);
  if (auto whole = reader.finish(); !whole)
    return tl::make_unexpected(std::move(whole.error()));
  return part;
}

} // namespace

std::string to_bytes(const script::Program& program, const TimedInput& input) {
  return part_to_bytes(program, input);
}

std::string to_bytes(const script::Program& program,
                     const PortAnswers& answers) {
  return part_to_bytes(program, answers);
}

Expected<TimedInput> read_input(std::shared_ptr<const script::Program> program,
                                std::string_view bytes) {
  return read_part<TimedInput>(std::move(program), bytes);
}

Expected<PortAnswers>
read_answers(std::shared_ptr<const script::Program> program,
             std::string_view bytes) {
  return read_part<PortAnswers>(std::move(program), bytes);
}

Replay::Replay(std::shared_ptr<const script::Program> program,
               Conversation::Options options)
    : port_(program), conversation_(std::make_unique<Conversation>(
                          program, std::move(options), port_)) {}

Expected<std::unique_ptr<Replay>>
Replay::from(std::shared_ptr<const script::Program> program,
             Conversation::Options options, std::string_view bytes) {
  auto replay = std::make_unique<Replay>(program, options);
  auto conversation = Conversation::restore(
      std::move(program), std::move(options), replay->port_, bytes);
  if (!conversation)
    return tl::make_unexpected(std::move(conversation.error()));
  replay->conversation_ = std::move(*conversation);
  return replay;
}

Expected<void> Replay::take(TimedInput input, PortAnswers answers) {
  port_.expect(std::move(answers));
  take(std::move(input));
  if (auto difference = port_.difference())
    return fail(ErrorKind::file, *std::move(difference));
  return {};
}

void Replay::take(TimedInput input, Port& live) {
  port_.ask(live);
  take(std::move(input));
}

// A frame's result is not kept, as it follows from the request: the port has
// computed it when the conversation asked.
void Replay::take(TimedInput input) {
  if (auto* applied = std::get_if<input::FrameApplied>(&input.what))
    applied->result = port_.take_frame();
  dialogue::take(*conversation_, std::move(input.what), input.now);
}

} // namespace parlour::dialogue
