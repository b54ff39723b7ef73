// `parlour journal`: looks into a journal (docs/running.md).
#include <ostream>

#include <fmt/format.h>

#include "script/run/phrase_evaluator.hpp"
#include "tools/parlour/application/opening.hpp"
#include "tools/parlour/cli/journal_commands.hpp"
#include "tools/parlour/cli/run/journal_damage.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/journal/session_replay.hpp"

namespace parlour::tools {

namespace {

std::string state_of(const dialogue::SessionHistory& history) {
  return history.closed ? "ended" : "open";
}

Expected<JournalSessions> read(const Places& places, const std::string& folder,
                               const Console& console) {
  auto journal =
      read_sessions(places.working / folder, dialogue::HistoryFrom::beginning);
  if (!journal)
    say_error(console, to_string(journal.error()));
  else
    tell_damage(*journal, folder, console);
  return journal;
}

int status_of(const JournalSessions& journal) {
  return journal.damages.empty() ? exit_code::success : exit_code::wrong;
}

LineForm form_of(const std::string& name) {
  return name == "json"   ? LineForm::json
         : name == "test" ? LineForm::test
                          : LineForm::transcript;
}

} // namespace

int journal_list_command(const Places& places, const JournalOptions& options,
                         const Console& console) {
  const auto journal = read(places, options.journal, console);
  if (!journal)
    return exit_code::usage;
  for (const auto& session : journal->sessions)
    console.out << fmt::format("{}  {:5}  {:6} inputs  program {:016x}{}\n",
                               session.id, state_of(session), session.count(),
                               session.opened.program,
                               session.opened.strict ? "  strict" : "");
  for (const auto& id : journal->broken)
    console.out << id << "  damaged\n";
  return status_of(*journal);
}

int journal_verify_command(const Places& places, const JournalOptions& options,
                           const Console& console) {
  const auto journal = read(places, options.journal, console);
  if (!journal)
    return exit_code::usage;
  std::uint64_t inputs = 0;
  std::size_t open = 0;
  for (const auto& session : journal->sessions) {
    inputs += session.inputs.size();
    open += !session.closed;
  }
  console.out << fmt::format(
      "{} sessions, {} of them open, {} inputs; {} damaged sessions\n",
      journal->sessions.size(), open, inputs, journal->broken.size());
  return status_of(*journal);
}

int journal_export_command(const Places& places, const JournalOptions& options,
                           const Console& console) {
  auto opened = open_application(places, options.app, console);
  if (const auto* status = std::get_if<int>(&opened))
    return *status;
  const auto& application = std::get<Application>(opened);
  const auto journal = read(places, options.journal, console);
  if (!journal)
    return exit_code::usage;
  if (options.as == "test" && options.session.empty() &&
      journal->sessions.size() > 1) {
    say_error(console, "a test is one conversation: name its session; parlour "
                       "journal list " +
                           options.journal + " has them");
    return exit_code::usage;
  }
  const auto outcome = replay_sessions(
      journal->sessions, application.program,
      script::make_phrase_evaluator(application.program),
      {options.session, {}, false, form_of(options.as)},
      [&](const std::string& line) { console.out << line << '\n'; });
  if (outcome.others > 0)
    say_warning(console, fmt::format("{} sessions were held with other scripts "
                                     "and are left out",
                                     outcome.others));
  if (outcome.sessions == 0)
    say_error(console, "no such session in " + options.journal);
  return outcome.sessions > 0 && outcome.differ == 0 ? status_of(*journal)
                                                     : exit_code::wrong;
}

} // namespace parlour::tools
