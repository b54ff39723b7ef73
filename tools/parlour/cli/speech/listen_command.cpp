// `parlour listen`: what an application's components from detector to
// understanding make of sound files, without a conversation.
#include <ostream>

#include "runtime/text/json_text.hpp"
#include "tools/parlour/application/opening.hpp"
#include "tools/parlour/application/understanding.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/speech/hearing_report.hpp"

namespace parlour::tools {

namespace {

using adapters::nlu::NluEngine;

// Nothing if the application has no GrammarNLU.
Expected<std::optional<NluEngine>> engine_of(const Application& application) {
  const auto* component = first_of_role(application.composition, "NLU");
  if (!component || component->factory.description.name != "GrammarNLU")
    return std::nullopt;
  auto built = build_engine(application, *component,
                            column_reader(rehearsed(application.composition),
                                          application.folder, ""));
  if (!built)
    return tl::make_unexpected(built.error().front());
  return std::optional<NluEngine>(std::move(*built));
}

UnderstoodTurn understand(const NluEngine& engine, const HeardTurn& turn,
                          const Map& context, bool why) {
  UnderstoodTurn understood;
  if (!turn.rejected.empty())
    return understood;
  const auto made = engine.understand(
      turn.text, with_alternatives(context, turn.alternatives), why);
  for (const auto& act : made.acts)
    understood.acts.push_back(to_string(act));
  understood.explanation = made.explanation;
  return understood;
}

// One run of the command.
class Listening {
public:
  Listening(const Application& application, const ListenOptions& options,
            std::unique_ptr<Ears> ears, std::optional<NluEngine> engine)
      : options_(options), ears_(std::move(ears)), engine_(std::move(engine)),
        context_(first_context(*application.program, SystemClock().now())) {}

  Expected<HearingReport> hear(const std::filesystem::path& working,
                               const std::string& file) {
    auto heard = ears_->hear(working / file);
    if (!heard)
      return tl::make_unexpected(heard.error());
    HearingReport report{file, ears_->recogniser(), std::move(*heard)};
    if (engine_)
      for (const auto& turn : report.heard.turns)
        report.understood.push_back(
            understand(*engine_, turn, context_, options_.why));
    return report;
  }

private:
  const ListenOptions& options_;
  const std::unique_ptr<Ears> ears_;
  const std::optional<NluEngine> engine_;
  const Map context_;
};

// Goes on after a file that cannot be heard.
int hear_all(const Places& places, const ListenOptions& options,
             Listening& listening, const Console& console) {
  int status = exit_code::success;
  List all;
  for (const auto& file : options.files) {
    const auto report = listening.hear(places.working, file);
    if (!report) {
      say_error(console, to_string(report.error()));
      status = exit_code::wrong;
    } else if (options.json) {
      all.push_back(report_value(*report));
    } else {
      console.out << report_text(*report, options.why) << std::flush;
    }
  }
  if (options.json)
    console.out << json_text(all) << '\n';
  return status_of_printing(console, status);
}

} // namespace

int listen_command(const Places& places, const ListenOptions& options,
                   const Console& console) {
  auto opened = open_application(places, options.app, console, VoiceWishes());
  if (const auto* status = std::get_if<int>(&opened))
    return *status;
  const auto& application = std::get<Application>(opened);
  auto engine = engine_of(application);
  if (!engine) {
    say_error(console, to_string(engine.error()));
    return exit_code::wrong;
  }
  auto ears = Ears::start(application);
  if (!ears) {
    say_error(console, to_string(ears.error()));
    return exit_code::wrong;
  }
  Listening listening(application, options, std::move(*ears),
                      std::move(*engine));
  return hear_all(places, options, listening, console);
}

} // namespace parlour::tools
