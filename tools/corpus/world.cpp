#include "tools/corpus/world.hpp"

#include <utility>

namespace parlour::tools::corpus {

using dialogue::Conversation;

namespace {

// The names under which words come from the user.
constexpr const char* seat = "corpus";
constexpr const char* recogniser = "ASR";

} // namespace

World::World(std::shared_ptr<const script::Program> its_program,
             std::shared_ptr<const PhraseEvaluator> phrases)
    : Surroundings(std::move(its_program)) {
  now = parse_timestamp("2019-03-01 09:00").value();
  components = {{"Database", {"Database"}}};
  database = [this](const auto& request) { return answer(request); };
  files = [](const auto&) {
    return fail(ErrorKind::file, "a corpus has no files");
  };
  changer = [](const auto&) {
    return fail(ErrorKind::refused, "a corpus has no components to change");
  };
  network = [](const auto&) {
    return fail(ErrorKind::network, "a corpus has no network");
  };
  hears = [this](const dialogue::Output& output) { said.push_back(output); };
  sees = [this](const Inspection& inspection) {
    if (inspection.kind == InspectionKind::error)
      errors.push_back(inspection.subject + ": " + inspection.detail);
  };
  Conversation::Options options;
  options.session = seat;
  options.phrases = std::move(phrases);
  conversation =
      std::make_unique<Conversation>(program, std::move(options), *this);
}

// A conversation that does not come to rest shows at its first utterance.
void World::open() {
  conversation->open(now);
  (void)run();
}

bool World::say(List acts) {
  Message message;
  message.source = recogniser;
  message.command = "RecognitionResult";
  message.params = {std::move(acts), 1};
  message.session = seat;
  conversation->receive(std::move(message));
  return run();
}

// Every query finds one row; scripts only ask whether there is one.
Expected<ResultSet> World::answer(const dialogue::QueryRequest& request) const {
  if (request.kind != dialogue::QueryRequest::Kind::query)
    return ResultSet{};
  if (!request.write)
    return ResultSet{{"found"}, {1}};
  if (!writes_succeed)
    return fail(ErrorKind::database, "refused");
  return ResultSet{};
}

} // namespace parlour::tools::corpus
