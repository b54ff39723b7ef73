#include "tools/parlour/speech/hearing_report.hpp"

#include <fmt/format.h>

namespace parlour::tools {

namespace {

double seconds(std::int64_t time) {
  return static_cast<double>(time) / 1'000;
}

std::string line(std::string_view name, std::string_view text) {
  return fmt::format("    {:<12} {}\n", name, text);
}

std::string range(std::int64_t begin, std::int64_t end) {
  return fmt::format("{:.2f} to {:.2f} s", seconds(begin), seconds(end));
}

// SphinxASR hears in two ways and tells of both.
bool are_two_texts(const List& alternatives) {
  return alternatives.size() == 2 && alternatives[0].if_string() &&
         alternatives[1].if_string();
}

std::string alternatives_text(const List& alternatives) {
  if (are_two_texts(alternatives))
    return line("by grammar", alternatives[0].text()) +
           line("by words", alternatives[1].text());
  std::string all;
  for (const auto& each : alternatives)
    all +=
        line("or", each.if_map() ? fmt::format("{} ({})", each["text"].text(),
                                               each["confidence"].text())
                                 : each.text());
  return all;
}

std::string partial_text(const HeardTurn::Partial& partial) {
  return line(fmt::format("{:.2f} s", seconds(partial.position)),
              partial.text + (!partial.ends   ? ""
                              : *partial.ends ? "  (may end here)"
                                              : "  (cannot end here)"));
}

std::string word_text(const Value& word) {
  const auto name = word["word"].is_unknown() ? word["text"] : word["word"];
  auto text = name.text();
  if (!word["begin"].is_unknown())
    text +=
        "  " + range(word["begin"].integer_or(0), word["end"].integer_or(0));
  if (!word["confidence"].is_unknown())
    text += "  " + word["confidence"].text();
  if (!word["agreed"].is_unknown() && !word["agreed"])
    text += "  (not agreed)";
  return line("word", text);
}

std::string turn_text(const HeardTurn& turn, bool why) {
  std::string all;
  for (const auto& partial : turn.partials)
    all += partial_text(partial);
  if (!turn.rejected.empty())
    return all + line("rejected", turn.rejected);
  all += line("heard", turn.text);
  if (!turn.confidence.is_unknown())
    all +=
        line("confidence", fmt::format("{:.2f}", turn.confidence.number_or(0)));
  all += alternatives_text(turn.alternatives);
  if (why)
    for (const auto& word : turn.words)
      all += word_text(word);
  return all;
}

std::string understood_text(const UnderstoodTurn& understood, bool why) {
  std::string all;
  if (why)
    for (const auto& each : understood.explanation)
      all += line("why", each);
  if (understood.acts.empty())
    all += line("understood", "nothing");
  for (const auto& act : understood.acts)
    all += line("understood", act);
  return all;
}

Value partial_value(const HeardTurn::Partial& partial) {
  return Map{{"at_ms", partial.position},
             {"text", partial.text},
             {"ends", partial.ends ? Value(*partial.ends) : Value()}};
}

List texts(const std::vector<std::string>& all) {
  return {all.begin(), all.end()};
}

Map turn_value(const HeardTurn& turn) {
  List partials;
  for (const auto& partial : turn.partials)
    partials.push_back(partial_value(partial));
  Map value{{"begin_ms", turn.begin},
            {"end_ms", turn.end},
            {"partials", std::move(partials)}};
  if (!turn.rejected.empty()) {
    value.set("rejected", turn.rejected);
    return value;
  }
  value.set("text", turn.text);
  value.set("confidence", turn.confidence);
  value.set("alternatives", turn.alternatives);
  value.set("words", turn.words);
  return value;
}

} // namespace

std::string report_text(const HearingReport& report, bool why) {
  const auto& heard = report.heard;
  auto all = fmt::format("{}: {:.2f} s, level {:.0f} dB, peak {:.0f} dB{}\n",
                         report.file, seconds(heard.length),
                         heard.level.level(), heard.level.peak(),
                         heard.level.clipped() > 0 ? ", cut off" : "");
  if (heard.speech.empty())
    all += "  no speech was found\n";
  for (const auto& segment : heard.speech)
    all += "  speech " + range(segment.begin, segment.end) + "\n";
  for (const auto& keyword : heard.keywords)
    all += fmt::format("  keyword {:.2f} s \"{}\" ({:.2f})\n",
                       seconds(keyword.position), keyword.text,
                       keyword.confidence.number_or(0));
  if (heard.sleeps && heard.keywords.empty())
    all += "  no keyword was said, so it sleeps and hears no turn\n";
  for (std::size_t i = 0; i < heard.turns.size(); ++i) {
    const auto& turn = heard.turns[i];
    all += fmt::format("  turn {} {}, by {}\n", i + 1,
                       range(turn.begin, turn.end), report.recogniser);
    all += turn_text(turn, why);
    if (i < report.understood.size() && turn.rejected.empty())
      all += understood_text(report.understood[i], why);
  }
  return all;
}

Value report_value(const HearingReport& report) {
  List speech, keywords, turns;
  for (const auto& segment : report.heard.speech)
    speech.push_back(Map{{"begin_ms", segment.begin}, {"end_ms", segment.end}});
  for (const auto& keyword : report.heard.keywords)
    keywords.push_back(Map{{"at_ms", keyword.position},
                           {"text", keyword.text},
                           {"confidence", keyword.confidence}});
  for (std::size_t i = 0; i < report.heard.turns.size(); ++i) {
    auto turn = turn_value(report.heard.turns[i]);
    if (i < report.understood.size()) {
      turn.set("acts", texts(report.understood[i].acts));
      turn.set("why", texts(report.understood[i].explanation));
    }
    turns.push_back(std::move(turn));
  }
  return Map{{"file", report.file},
             {"length_ms", report.heard.length},
             {"level_db", report.heard.level.level()},
             {"peak_db", report.heard.level.peak()},
             {"clipped", report.heard.level.clipped()},
             {"recogniser", report.recogniser},
             {"speech", std::move(speech)},
             {"keywords", std::move(keywords)},
             {"turns", std::move(turns)}};
}

} // namespace parlour::tools
