// `parlour understand`: what an application makes of one text and why, of many
// sentences, or how much of marked sentences (understand/).
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <system_error>

#include "runtime/text/json_text.hpp"
#include "tools/parlour/application/opening.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/bounded_line.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/line_reader.hpp"
#include "tools/parlour/understand/reader.hpp"
#include "tools/parlour/understand/score_table.hpp"

namespace parlour::tools {

namespace {

// The words that were sent, if scripts changed them; the explanation; then the
// acts, then the score of the best reading.
void print(std::ostream& out, const std::string& text, const Reading& reading) {
  const auto& understanding = reading.made;
  if (!reading.sent)
    out << "sent nothing: the application's scripts kept it\n";
  else if (reading.sent->text != text)
    out << "sent " << reading.sent->text << '\n';
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

// A line of JSON for each sentence, at once, so that a program may ask and
// wait. Of a line that is too long, the rest is passed over.
int read_lines(Reader& reader, const Map& context, std::istream& in,
               const Console& console) {
  while (const auto line = read_bounded_line(in, longest_line)) {
    if (line->is_cut)
      in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    const auto text = well_formed(line->text);
    console.out << reading_line(text, reader.read(text, context, false))
                << std::endl;
  }
  return exit_code::success;
}

int read_marked(Reader& reader, const Map& context,
                const std::vector<MarkedSentence>& sentences,
                const Console& console) {
  ScoreTable table;
  for (const auto& sentence : sentences) {
    auto all = context;
    for (const auto& [key, value] : sentence.context.entries())
      all.set(key, value);
    const auto reading = reader.read(well_formed(sentence.text), all, false);
    table.add(sentence, reading.made.acts, reading.made.score);
  }
  for (const auto& line : table.lines())
    console.out << line << '\n';
  return exit_code::success;
}

// Nothing if it is no JSON object.
std::optional<Map> context_of(const std::string& text) {
  if (text.empty())
    return Map();
  const auto read = read_json(text);
  if (!read || !read->if_map())
    return {};
  return *read->if_map();
}

// One way to use the command is chosen.
std::string mistake_in(const UnderstandOptions& options) {
  const int ways = (options.text.empty() ? 0 : 1) + (options.batch ? 1 : 0) +
                   (options.score.empty() ? 0 : 1);
  if (ways == 0)
    return "TEXT is required, or --batch, or --score";
  if (ways > 1)
    return "TEXT, --batch and --score are three ways; choose one";
  return context_of(options.context)
             ? ""
             : R"(--context is a JSON object: {"asked": {"topic": "Taxi", )"
               R"("slot": "Time"}})";
}

Expected<std::vector<MarkedSentence>> marked_in(const Places& places,
                                                const std::string& name) {
  const auto path = places.working / name;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    return fail(ErrorKind::file, "this is a folder, not a file", {name, 0, 0});
  std::ifstream file(path);
  if (!file)
    return fail(ErrorKind::file, "this file cannot be read", {name, 0, 0});
  return read_marked_sentences(file, name);
}

int understand(Reader& reader, const UnderstandOptions& options,
               const std::vector<MarkedSentence>& marked,
               const Console& console) {
  const auto context = *context_of(options.context);
  if (options.batch)
    return read_lines(reader, context, std::cin, console);
  if (!options.score.empty())
    return read_marked(reader, context, marked, console);
  const auto text = well_formed(options.text);
  print(console.out, text, reader.read(text, context, true));
  return exit_code::success;
}

} // namespace

int understand_command(const Places& places, const UnderstandOptions& options,
                       const Console& console) {
  if (const auto mistake = mistake_in(options); !mistake.empty()) {
    say_error(console, mistake);
    return exit_code::usage;
  }
  const auto marked = options.score.empty() ? std::vector<MarkedSentence>()
                                            : marked_in(places, options.score);
  if (!marked) {
    say_error(console, to_string(marked.error()));
    return exit_code::wrong;
  }
  auto opened = open_application(places, options.app, console);
  if (const auto* status = std::get_if<int>(&opened))
    return *status;
  const auto& application = std::get<Application>(opened);
  const auto* component = first_of_role(application.composition, "NLU");
  if (!component || component->factory.description.name != "GrammarNLU") {
    say_error(console, options.app + " has no GrammarNLU to ask");
    return exit_code::wrong;
  }
  auto reader = Reader::open(application, *component,
                             options.clock.value_or(SystemClock().now()));
  if (reader)
    return understand(*reader, options, *marked, console);
  for (const auto& error : reader.error())
    say_error(console, to_string(error));
  return exit_code::wrong;
}

} // namespace parlour::tools
