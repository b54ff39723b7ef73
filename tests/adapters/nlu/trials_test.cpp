// Figures of trials that are kept as data (trials/README.md). They are printed,
// and may not fall below what was reached.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>

#include "adapters/nlu/understand/nlu_engine.hpp"
#include "runtime/text/edit_distance.hpp"
#include "tests/support/paths.hpp"

namespace parlour::adapters::nlu {
namespace {

using Row = std::vector<std::string>;

std::string trial(const std::string& name) {
  return parlour::test::source_path("tests/adapters/nlu/trials/" + name);
}

std::vector<Row> rows_of(const std::string& name) {
  std::ifstream file(trial(name));
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, '\t');)
      rows.back().push_back(cell);
  }
  return rows;
}

std::vector<std::string> lines_of(const std::string& name) {
  std::vector<std::string> lines;
  for (auto& row : rows_of(name))
    lines.push_back(row.at(0));
  return lines;
}

std::string text_of(const std::string& path) {
  std::ifstream file(parlour::test::source_path(path));
  return {std::istreambuf_iterator<char>(file), {}};
}

NluEngine engine_of(const UnderstandingModel& model,
                    const std::vector<std::string>& names = {}) {
  const std::vector<GrammarModel> generic{
      {"generic", text_of("config/platform/generic-acts.jsgf"), {}}};
  auto engine =
      NluEngine::build(model,
                       [&](const std::string&) {
                         return Expected<std::vector<std::string>>(names);
                       },
                       {0.4, generic});
  if (!engine)
    throw std::runtime_error(to_string(engine.error().at(0)));
  return std::move(*engine);
}

// The baseline takes most of a minute, so it is printed on request.
bool prints_baselines() {
  return std::getenv("PARLOUR_BASELINES") != nullptr;
}

double percent(int part, int whole) {
  return whole == 0 ? 0 : 100.0 * part / whole;
}

// -- names --------------------------------------------------------------------

struct NameFigures {
  double first = 0;   // of known people: found, and nobody else
  double wrong = 0;   // taken for somebody else
  double as_one = 0;  // of strangers: taken for one person
  double as_some = 0; // asked which person is meant
};

// The only person that was understood; "?" if there are several, empty if there
// is none.
std::string host_of(const Understanding& made) {
  for (const auto& act : made.acts) {
    const auto host = act["slots"]["Host"];
    if (host.if_map() && !host["unmatched"])
      return host["candidates"].if_list() ? "?" : host["value"].text();
  }
  return "";
}

template <class Understand>
NameFigures names(const std::vector<Row>& rows, const Understand& understand) {
  int known = 0, first = 0, wrong = 0, strangers = 0, one = 0, some = 0;
  for (auto row : rows) {
    row.resize(5);
    const auto person = understand(row[4]);
    const bool single = !person.empty() && person != "?";
    if (row[0].empty()) {
      ++strangers;
      one += single ? 1 : 0;
      some += person == "?" ? 1 : 0;
    } else {
      ++known;
      first += person == row[0] ? 1 : 0;
      wrong += single && person != row[0] ? 1 : 0;
    }
  }
  return {percent(first, known), percent(wrong, known), percent(one, strangers),
          percent(some, strangers)};
}

NameFigures measured(const std::string& part) {
  UnderstandingModel model;
  model.topics = {{"Visit",
                   false,
                   {{"Host", "query", {}, "db:people.name", true, false}},
                   {}}};
  model.grammars = {{"visit",
                     "public <meet> = (meet | see | appointment with) "
                     "@Visit.Host;",
                     {"trial", 1, 1}}};
  const auto engine = engine_of(model, lines_of(part + "-staff.txt"));
  const Value context(
      Map{{"asked", Map{{"topic", "Visit"}, {"slot", "Host"}}}});
  const auto found = names(rows_of(part + ".tsv"), [&](const auto& text) {
    return host_of(engine.understand(text, context));
  });
  std::printf("names %s: first %.1f %%, wrong %.1f %%; strangers taken as one "
              "%.1f %%, asked which %.1f %%\n",
              part.c_str(), found.first, found.wrong, found.as_one,
              found.as_some);
  return found;
}

// What a few lines reach: the name whose letters are nearest to those of the
// end of the sentence, if fewer than a third of them differ.
NameFigures baseline(const std::string& part) {
  const auto staff = lines_of(part + "-staff.txt");
  const auto nearest = [&](const std::string& text) {
    std::string best;
    auto least = 1.0 / 3;
    for (auto name : staff) {
      const auto whole = name;
      for (auto& letter : name)
        letter = static_cast<char>(std::tolower(letter));
      const auto end =
          text.substr(text.size() - std::min(text.size(), name.size()));
      const auto distance = double(edit_distance<64>(end, name)) /
                            double(std::max<std::size_t>(1, name.size()));
      if (distance < least) {
        least = distance;
        best = whole;
      }
    }
    return best;
  };
  const auto found = names(rows_of(part + ".tsv"), nearest);
  std::printf("names %s, nearest letters: first %.1f %%, strangers taken as "
              "one %.1f %%\n",
              part.c_str(), found.first, found.as_one);
  return found;
}

TEST(NameTrial, FindsNamesThatAreWrittenByEar) {
  if (prints_baselines())
    baseline("written-choosing");
  const auto choosing = measured("written-choosing");
  if (prints_baselines())
    baseline("written-final");
  const auto last = measured("written-final");
  EXPECT_GE(choosing.first, 90);
  EXPECT_LE(choosing.wrong, 1.5);
  EXPECT_GE(last.first, 70);
  EXPECT_LE(last.as_one, 5);
  EXPECT_LE(last.as_some, 10);
}

// Recognisers that know none of the names hear other words for most of them, so
// that hardly one can be found; what counts is that nobody is taken for
// another.
TEST(NameTrial, TakesNobodyForAnotherWhoIsHeardBadly) {
  if (prints_baselines())
    for (const auto* part : {"spoken-choosing", "spoken-final"})
      baseline(part);
  for (const auto* part :
       {"spoken-training", "spoken-choosing", "spoken-final"}) {
    const auto found = measured(part);
    EXPECT_LE(found.wrong, 6) << part;
    EXPECT_LE(found.as_one, 12) << part;
  }
}

// -- yes, no and the like -----------------------------------------------------

UnderstandingModel home() {
  UnderstandingModel model;
  model.topics = {{"Light",
                   false,
                   {{"Place",
                     "set",
                     {"kitchen", "bedroom", "living room", "garden"},
                     "",
                     true,
                     false},
                    {"State", "set", {"on", "off"}, "", true, false}},
                   {}},
                  {"Alarm", false, {{"Time", "time", {}, "", true, false}}, {}},
                  {"Music", false, {}, {}},
                  {"Fan", false, {}, {}}};
  model.grammars = {
      {"Light",
       "public <set> = (turn | switch | put) {act=inform} [@Light.State] [the] "
       "(light | lights | lamp) [@Light.State] [[in | of] [the] @Light.Place];"
       "public <place> = [the] @Light.Place (light | lights);",
       {}},
      {"Alarm",
       "public <set> = (set | make) {act=inform} [an | the | my] alarm "
       "[(for | at) @time{Time}]; public <cancel> = cancel {act=inform} "
       "(the | my) [@time{Time}] alarm;",
       {}},
      {"Music", "public <play> = (play | stop) {act=inform} [the] music;", {}},
      {"Fan", "public <on> = turn on {act=inform} the fan;", {}}};
  return model;
}

// The acts without a topic, and "topic" if there is one with a topic.
std::map<std::string, bool> acts_of(const Understanding& made) {
  std::map<std::string, bool> acts;
  for (const auto& act : made.acts)
    acts[act["topic"].is_unknown() ? act["act"].text() : "topic"] = true;
  return acts;
}

bool is_right(const std::string& wanted, std::map<std::string, bool> acts) {
  const bool yes = acts["confirm"], no = acts["deny"], topic = acts["topic"];
  const bool cancel = acts["cancel"] || acts["abandon"];
  if (wanted == "yes")
    return yes && !no && !cancel && !topic;
  if (wanted == "no")
    return no && !yes && !topic;
  if (wanted == "both") // asked back
    return yes == no;
  if (wanted == "none")
    return !yes && !no && !cancel && !topic;
  if (wanted == "application")
    return topic && !cancel;
  if (wanted == "help")
    return acts["help"] || acts["options"];
  static const std::map<std::string, std::string> names{
      {"hello", "greet"}, {"goodbye", "bye"}, {"thanks", "thank"}};
  const auto name = names.find(wanted);
  return wanted == "cancel" ? cancel
                            : acts[name == names.end() ? wanted : name->second];
}

// Half 0 is for choosing, half 1 for the figure.
double polarity(int half) {
  const auto engine = engine_of(home());
  const Value asked(Map{{"confirms", "shall i do that"}});
  std::map<std::string, int> seen;
  int right = 0, all = 0;
  for (const auto& row : rows_of("polarity.tsv")) {
    if (seen[row.at(0)]++ % 2 != half)
      continue;
    ++all;
    const auto context = row[0] == "application" ? Value() : asked;
    right += is_right(row[0], acts_of(engine.understand(row.at(1), context)))
                 ? 1
                 : 0;
  }
  std::printf("polarity, half %d: %d sentences, right %.1f %%\n", half + 1, all,
              percent(right, all));
  return percent(right, all);
}

TEST(PolarityTrial, TellsYesFromNoAndFromNeither) {
  EXPECT_GE(polarity(0), 95);
  EXPECT_GE(polarity(1), 90);
}

} // namespace
} // namespace parlour::adapters::nlu
