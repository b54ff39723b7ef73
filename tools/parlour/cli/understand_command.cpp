// `parlour understand`: builds the application's GrammarNLU without a node and
// prints what it makes of one text (application/understanding.hpp).
#include <ostream>

#include "tools/parlour/application/opening.hpp"
#include "tools/parlour/application/understanding.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/line_reader.hpp"

namespace parlour::tools {

namespace {

using adapters::nlu::Understanding;

// The explanation, then the acts, then the score of the best reading.
void print(std::ostream& out, const Understanding& understanding) {
  for (const auto& line : understanding.explanation)
    out << line << '\n';
  if (understanding.acts.empty())
    out << "not understood: NoResult\n";
  for (const auto& act : understanding.acts)
    out << to_string(act) << '\n';
  out << "score " << number_text(understanding.score) << '\n';
}

// The text as the robot would get it from a line of input: invalid UTF-8
// replaced, lines joined by blanks.
std::string well_formed(std::string_view text) {
  LineReader reader;
  std::string all;
  while (auto line = reader.take(text))
    all += line->text + ' ';
  if (auto line = reader.finish())
    all += line->text;
  return all;
}

} // namespace

int understand_command(const Places& places, const UnderstandOptions& options,
                       const Console& console) {
  auto opened = open_application(places, options.app, console);
  if (const auto* status = std::get_if<int>(&opened))
    return *status;
  const auto& application = std::get<Application>(opened);
  const auto* component = first_of_role(application.composition, "NLU");
  if (!component || component->factory.description.name != "GrammarNLU") {
    say_error(console, options.app + " has no GrammarNLU to ask");
    return exit_code::wrong;
  }
  // Columns come from a copy of the database in memory, so no run's data
  // matter.
  const auto built =
      build_engine(application, *component,
                   column_reader(rehearsed(application.composition),
                                 application.folder, ""));
  if (!built) {
    for (const auto& error : built.error())
      say_error(console, to_string(error));
    return exit_code::wrong;
  }
  const auto context = first_context(
      *application.program, options.clock.value_or(SystemClock().now()));
  print(console.out,
        built->understand(well_formed(options.text), context, true));
  return exit_code::success;
}

} // namespace parlour::tools
