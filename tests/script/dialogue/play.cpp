#include "tests/script/dialogue/play.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <sstream>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {

namespace {

struct Line {
  std::string verb; // "say"
  std::string rest; // "inform Taxi Time=3pm"
};

std::string text_of(const std::filesystem::path& file) {
  std::ifstream input(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

std::vector<Line> lines_of(const std::string& script) {
  static const std::regex comment("<!-- ([a-z]+)(?:: (.*?))? -->");
  std::vector<Line> lines;
  for (std::sregex_iterator at(script.begin(), script.end(), comment), end;
       at != end; ++at)
    lines.push_back({(*at)[1], (*at)[2]});
  return lines;
}

// The children of <dialogue>.
std::string declarations(const std::string& script) {
  const auto start = script.find("<dialogue>") + 10;
  return script.substr(start, script.rfind("</dialogue>") - start);
}

std::vector<std::string> words_of(const std::string& text, char separator) {
  std::vector<std::string> words;
  std::istringstream input(text);
  for (std::string word; std::getline(input, word, separator);)
    if (const auto start = word.find_first_not_of(' ');
        start != std::string::npos)
      words.push_back(word.substr(start));
  return words;
}

std::vector<Value> values_of(const std::vector<std::string>& words,
                             std::size_t from) {
  std::vector<Value> values;
  for (auto at = from; at < words.size(); ++at)
    values.emplace_back(words[at]);
  return values;
}

class Stage : public World {
public:
  using World::World;
  void release(const Output& output) override {
    interruptible = output.interruptible;
    World::release(output);
  }
  bool interruptible = true; // of the last output
};

class Play {
public:
  explicit Play(const std::string& script)
      : lines_(lines_of(script)),
        world_(declarations(script), options_of(lines_)) {
    world_.database = [this](const QueryRequest& request) {
      constexpr const char* kinds[] = {"", "begin", "commit", "rollback"};
      asked_.push_back(kinds[static_cast<std::size_t>(request.kind)] +
                       request.sql + " " + to_string(Value(request.values)) +
                       (request.database.empty() ? "" : " of ") +
                       request.database + (request.write ? ", write" : ""));
      return answer(request);
    };
  }

  void run() {
    for (const auto& line : lines_)
      if (line.verb == "component")
        add_component(words_of(line.rest, ' '));
    world_.open();
    for (const auto& line : lines_) {
      SCOPED_TRACE(line.verb + ": " + line.rest);
      if (!act(line))
        expect(line);
    }
    listen();
    EXPECT_EQ(said_, Texts{});
    EXPECT_EQ(posted_, Texts{});
    EXPECT_EQ(asked_, Texts{});
    for (auto at = errors_; at < errors().size(); ++at)
      ADD_FAILURE() << errors()[at];
  }

private:
  Expected<ResultSet> answer(const QueryRequest& request) const {
    if (failure_)
      return tl::make_unexpected(*failure_);
    return request.kind == QueryRequest::Kind::query ? rows_ : ResultSet{};
  }

  static WorldOptions options_of(const std::vector<Line>& lines) {
    WorldOptions options;
    options.open = false;
    for (const auto& line : lines)
      if (line.verb == "start")
        options.start = line.rest;
      else if (line.verb == "settings")
        options.settings = line.rest;
      else if (line.verb == "sessions")
        options.sessions = line.rest;
    return options;
  }

  void add_component(const std::vector<std::string>& words) {
    world_.components[words.at(0)] = {words.begin() + 1, words.end()};
  }

  bool act(const Line& line) {
    const auto words = words_of(line.rest, ' ');
    if (line.verb == "say")
      world_.say(acts_of(line.rest));
    else if (line.verb == "breath")
      world_.queue(acts_of(line.rest));
    else if (line.verb == "event")
      event(words, 0);
    else if (line.verb == "broadcast")
      broadcast(words);
    else if (line.verb == "reply")
      event(words, world_.messages.back().correlation);
    else if (line.verb == "wait")
      world_.advance(*parse_duration(line.rest));
    else if (line.verb == "rows")
      set_rows(words_of(line.rest, ';'));
    else if (line.verb == "fails")
      fail_from_now_on(line.rest);
    else
      return line.verb == "start" || line.verb == "settings" ||
             line.verb == "sessions" || line.verb == "component";
    return true;
  }

  static List acts_of(const std::string& line) {
    List acts;
    for (const auto& act : words_of(line, '+'))
      acts.push_back(act_of(words_of(act, ' ')));
    return acts;
  }

  static Value act_of(const std::vector<std::string>& words) {
    Map act{{"act", words.at(0)}};
    if (words.size() > 1 && words[1] != "-")
      act.set("topic", words[1]);
    Map slots;
    for (std::size_t i = 2; i < words.size(); ++i)
      if (words[i] == "elliptical")
        act.set("elliptical", true);
      else if (words[i] == "sure")
        act.set("confidence", 1);
      else
        add_slot(slots, words[i]);
    act.set("slots", std::move(slots));
    return act;
  }

  // "Time=3pm~0.5": a slot's value with its confidence.
  static void add_slot(Map& slots, std::string word) {
    std::replace(word.begin(), word.end(), '_', ' ');
    const auto equals = word.find('=');
    const auto sure = std::min(word.find('~'), word.size());
    auto said = word.substr(equals + 1, sure - equals - 1);
    const auto name = word.substr(0, equals);
    if (const auto times = said.find('*'); times != std::string::npos) {
      add_item(slots, name, said.substr(0, times), said.substr(times + 1));
      return;
    }
    auto value = slot_value(
        said, sure < word.size() ? std::stod(word.substr(sure + 1)) : 1);
    if (said.find('|') != std::string::npos)
      value = Map{{"text", said},
                  {"candidates", values_of(words_of(said, '|'), 0)}};
    slots.set(name, std::move(value));
  }

  // "Items=tea*2", "Items=tea*1more": one of several values.
  static void add_item(Map& slots, const std::string& name,
                       const std::string& said, const std::string& amount) {
    Map item{{"value", said}, {"confidence", 1}};
    if (amount.find_first_of("0123456789") != std::string::npos)
      item.set("amount", std::stoi(amount));
    if (amount.ends_with("more"))
      item.set("more", true);
    const auto* known = slots.find(name);
    auto items = known ? *(*known)["items"].if_list() : List();
    items.emplace_back(std::move(item));
    slots.set(name, Map{{"items", std::move(items)}});
  }

  void event(const std::vector<std::string>& words, Correlation correlation) {
    const auto dot = words.at(0).find('.');
    world_.event(words[0].substr(0, dot), words[0].substr(dot + 1),
                 values_of(words, 1), correlation);
  }

  void broadcast(const std::vector<std::string>& words) {
    const auto dot = words.at(0).find('.');
    world_.broadcast(words[0].substr(0, dot), words[0].substr(dot + 1),
                     values_of(words, 1));
  }

  void set_rows(const std::vector<std::string>& words) {
    rows_ = rows({words.at(0)}, values_of(words, 1));
  }

  void fail_from_now_on(const std::string& text) {
    const auto blank = text.find(' ');
    const auto kind = text.substr(0, blank);
    failure_ = Error{ErrorKind::database, text.substr(blank + 1), {}};
#define X(name, written, sentence)                                             \
  if (kind == written)                                                         \
    failure_->kind = ErrorKind::name;
    PARLOUR_ERROR_KINDS(X)
#undef X
  }

  void listen() {
    for (auto& text : world_.said())
      said_.push_back(std::move(text));
    for (auto& text : world_.posted())
      posted_.push_back(std::move(text));
  }

  void expect(const Line& line) {
    listen();
    if (line.verb == "said")
      EXPECT_EQ(first_of(said_), line.rest);
    else if (line.verb == "posted")
      EXPECT_EQ(first_of(posted_), line.rest);
    else if (line.verb == "asked")
      EXPECT_EQ(first_of(asked_), line.rest);
    else if (line.verb == "interruptible")
      EXPECT_EQ(world_.interruptible ? "true" : "false", line.rest);
    else if (line.verb == "state")
      EXPECT_EQ(world_.conversation->state(), line.rest);
    else if (line.verb == "topic")
      EXPECT_EQ(world_.conversation->current_topic(), line.rest);
    else if (line.verb == "slot")
      expect_slot(line.rest);
    else if (line.verb == "error")
      expect_error(line.rest);
    else if (line.verb == "ended")
      EXPECT_TRUE(world_.has_ended);
    else
      ADD_FAILURE() << "'" << line.verb << "' is no part of a play";
  }

  static std::string first_of(Texts& texts) {
    if (texts.empty())
      return "(nothing)";
    auto first = texts.front();
    texts.erase(texts.begin());
    return first;
  }

  void expect_slot(const std::string& text) {
    const auto dot = text.find('.');
    const auto equals = text.find(" = ");
    EXPECT_EQ(world_
                  .slot(text.substr(0, dot).c_str(),
                        text.substr(dot + 1, equals - dot - 1).c_str())
                  .text(),
              text.substr(equals + 3));
  }

  Texts errors() const {
    return world_.seen(InspectionKind::error);
  }

  void expect_error(const std::string& text) {
    ASSERT_LT(errors_, errors().size()) << "no error";
    const auto error = errors()[errors_++];
    EXPECT_NE(error.find(text), std::string::npos) << error;
  }

  std::vector<Line> lines_;
  Stage world_;
  ResultSet rows_;
  std::optional<Error> failure_; // of the database
  Texts said_;
  Texts posted_;
  Texts asked_;
  std::size_t errors_ = 0; // expected so far
};

} // namespace

void expect_as_in_play(const std::filesystem::path& file) {
  const auto script = text_of(file);
  ASSERT_FALSE(lines_of(script).empty()) << "nothing happens in the play";
  Play(script).run();
}

} // namespace parlour::dialogue
