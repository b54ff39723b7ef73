// Restores a conversation from any bytes. If they are accepted, saving and
// restoring again must give the same bytes, and the conversation must go on
// with two dozen inputs.
//
// The input leaves out what a fuzzer would have to find: it begins with the
// size of the interpreter's state in two bytes, then that state behind its
// version and program, then the parts. With the argument -corpus=FOLDER real
// states are written there.
#include <cstdlib>
#include <fstream>

#include "runtime/base/bytes.hpp"
#include "script/compiler/compiler.hpp"
#include "tools/world/surroundings.hpp"

namespace parlour::fuzz {

namespace {

using dialogue::Conversation;

constexpr std::size_t state_header = 9;
constexpr Timestamp morning = 1'795'251'600'000;
constexpr int most_steps = 200;

std::shared_ptr<const script::Program> program() {
  static const auto compiled = [] {
    script::CompileOptions options;
    options.platform = PARLOUR_SOURCE_DIR "/config/platform";
    return script::compile_application(
        PARLOUR_SOURCE_DIR "/tests/fuzz/conversation", options);
  }();
  if (!compiled.program)
    std::abort();
  return compiled.program;
}

// It notes every request and answers none: the answers are inputs here.
struct SilentWorld : tools::Surroundings {
  SilentWorld() : Surroundings(fuzz::program()) {
    has_frame_actors = false;
  }
  bool reachable(const std::string&) const override {
    return true;
  }
};

// -- the input and the bytes of a conversation --------------------------------

struct Parts {
  std::string version;
  std::string state; // of the interpreter
  std::string rest;
};

Parts parts_of(const std::string& bytes) {
  ByteReader reader(std::string_view(bytes).substr(1));
  const auto state = reader.block();
  const auto end =
      static_cast<std::size_t>(state.data() - bytes.data()) + state.size();
  return {bytes.substr(0, 1), std::string(state), bytes.substr(end)};
}

std::string input_of(const std::string& bytes) {
  const auto parts = parts_of(bytes);
  const auto size = parts.state.size() - state_header;
  return std::string{static_cast<char>(size & 0xff),
                     static_cast<char>(size >> 8)} +
         parts.state.substr(state_header) + parts.rest;
}

std::string bytes_of(std::string_view input, const Parts& start) {
  if (input.size() < 2)
    return {};
  const auto size =
      static_cast<std::size_t>(static_cast<unsigned char>(input[0]) |
                               static_cast<unsigned char>(input[1]) << 8);
  input.remove_prefix(2);
  ByteWriter state;
  state.text(start.state.substr(0, state_header) +
             std::string(input.substr(0, size)));
  return start.version + state.take() +
         std::string(input.substr(std::min(size, input.size())));
}

// -- what happens -------------------------------------------------------------

Message said(Value acts) {
  Message message;
  message.source = "ASR";
  message.command = "RecognitionResult";
  message.params = {std::move(acts), 1};
  return message;
}

Value act(const char* kind, Value topic = {}, Map slots = {}) {
  return Map{{"act", kind}, {"topic", std::move(topic)}, {"slots", slots}};
}

Message event(const char* source, const char* command) {
  Message message;
  message.source = source;
  message.command = command;
  return message;
}

void run(Conversation& conversation, Timestamp now) {
  for (int i = 0; i < most_steps && conversation.step(now); ++i) {
  }
}

// One thing of everything that can happen.
void happens(Conversation& conversation, int what) {
  const auto now = morning + what * 1000;
  switch (what % 12) {
  case 0:
    conversation.receive(event("Bell", "Rings"));
    break;
  case 1:
    conversation.receive(said(act("inform", "Taxi", {{"Where", "Jurong"}})));
    break;
  case 2:
    conversation.receive(
        said(List{act("confirm"), act("inform", "Shops", {{"Kind", "food"}})}));
    break;
  case 3:
    conversation.receive(said(act("inform", {}, {{"When", "noon"}})));
    break;
  case 4:
    conversation.receive(event("Door", "Opens"));
    break;
  case 5:
    conversation.receive(said(act("confirm")));
    break;
  case 6:
    for (dialogue::TimerId id = 1; id < 40; ++id)
      conversation.timer_fired(id, now);
    break;
  case 7:
    conversation.receive(said(act("deny")));
    break;
  case 8:
    conversation.query_answered(1, ResultSet{}, now);
    conversation.socket_opened(1, {}, now);
    break;
  case 9:
    for (dialogue::OutputId id = 1; id < 20; ++id)
      conversation.output_finished(id, id % 3 > 0, now);
    break;
  case 10:
    conversation.receive(said(act("help")));
    break;
  case 11:
    conversation.receive(said(act("cancel")));
    break;
  }
  run(conversation, now);
}

void go_on(Conversation& conversation) {
  run(conversation, morning);
  for (int what = 0; what < 24; ++what)
    happens(conversation, what);
  conversation.close(morning + 60'000);
  run(conversation, morning + 60'000);
}

// What is saved after each of these.
void write_states(const std::filesystem::path& folder) {
  SilentWorld world;
  Conversation conversation(program(), {}, world);
  conversation.open(morning);
  for (int what = 0; what < 48; ++what) {
    std::ofstream(folder / ("conversation-" + std::to_string(what)),
                  std::ios::binary)
        << input_of(conversation.save());
    happens(conversation, what * 5);
  }
}

} // namespace

} // namespace parlour::fuzz

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  const std::string option = "-corpus=";
  const std::string last = (*arguments)[*count - 1];
  if (last.starts_with(option)) {
    parlour::fuzz::write_states(last.substr(option.size()));
    std::exit(0);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  using namespace parlour::fuzz;
  SilentWorld world;
  static const auto start = parts_of(Conversation(program(), {}, world).save());
  const auto bytes =
      bytes_of({reinterpret_cast<const char*>(data), size}, start);
  auto conversation = Conversation::restore(program(), {}, world, bytes);
  if (!conversation)
    return 0;
  const auto once = (*conversation)->save();
  auto again = Conversation::restore(program(), {}, world, once);
  if (!again || (*again)->save() != once)
    std::abort();
  go_on(**conversation);
  return 0;
}
