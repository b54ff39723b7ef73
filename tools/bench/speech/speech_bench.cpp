#include "tools/bench/speech/speech_bench.hpp"

#include <algorithm>
#include <array>
#include <ostream>
#include <utility>

#include <fmt/format.h>

#include "tools/bench/speech/conversation_rows.hpp"
#include "tools/bench/speech/detector_row.hpp"
#include "tools/bench/speech/load_row.hpp"
#include "tools/bench/speech/sentence_rows.hpp"
#include "tools/parlour/application/opening.hpp"
#include "tools/parlour/voice_test/voice_report.hpp"

namespace parlour::tools {

namespace {

using Kind = NoiseWish::Kind;

const std::vector<ConversationRow>& conversation_rows() {
  static const std::vector<ConversationRow> rows{
      {"clean", {}, 2, 95},
      {"babble-20", {Kind::babble, 20}, 5, 90},
      {"babble-10", {Kind::babble, 10}, 10, 0}};
  return rows;
}

constexpr std::size_t names_tried = 600;
constexpr std::size_t lines_of_detector = 60;
// The column with the names.
const char* const staff_names = "db:rr_staff.staff_name";

// Every so manieth.
template <class T>
std::vector<T> one_in(const std::vector<T>& all, std::size_t step) {
  std::vector<T> some;
  for (std::size_t i = 0; i < all.size(); i += step)
    some.push_back(all[i]);
  return some;
}

class Table {
public:
  Table(const Places& places, const SpeechBenchOptions& options,
        const Console& console, const Application& typed,
        const Application& spoken)
      : places_(places), options_(options), out_(console.out), typed_(typed),
        spoken_(spoken), bank_(typed.plugins) {}

  bool print() {
    const auto sentences =
        read_sentences(std::filesystem::path(PARLOUR_SENTENCES));
    if (!sentences) {
      out_ << to_string(sentences.error()) << '\n';
      return false;
    }
    sentences_ = *sentences;
    const auto* recogniser = first_of_role(spoken_.composition, "ASR");
    out_ << fmt::format("recogniser {}, {}\n",
                        recogniser ? recogniser->name : "none",
                        options_.told ? "told what is said in dialogues/"
                                      : "not told what is said in dialogues/");
    bool ok = !wants("load") || load();
    ok &= !wants("detector") || detector();
    ok &= sentence_rows();
    for (const auto& row : conversation_rows())
      ok &= !wants(row.name) || conversations(row);
    return ok;
  }

private:
  bool wants(std::string_view row) const {
    return options_.only.empty() || options_.only == row;
  }

  const std::string& first_voice() const {
    return options_.voices.front();
  }
  const std::vector<std::string>& belonging() const {
    return sentences_.at("belongs");
  }

  bool load() {
    return load_row(spoken_, bank_, options_.told, belonging(), first_voice(),
                    out_);
  }

  bool detector() {
    auto lines = belonging();
    for (const auto& line : sentences_.at("foreign"))
      if (lines.size() < lines_of_detector)
        lines.push_back(line);
    return detector_row(spoken_, bank_, lines, first_voice(), out_);
  }

  bool sentence_rows() {
    if (!wants("foreign") && !wants("names") && !wants("digits"))
      return true;
    const auto listener = Listener::start(spoken_, options_.told);
    if (!listener) {
      out_ << to_string(listener.error()) << '\n';
      return false;
    }
    SentenceRows rows{**listener, bank_, options_.voices, options_.trace, out_};
    bool ok = !wants("foreign") || rows.foreign(sentences_);
    ok &= !wants("names") || names(rows);
    ok &= !wants("digits") || rows.digits(options_.data, options_.speakers);
    return ok;
  }

  bool names(SentenceRows& rows) {
    const auto names = column_reader(rehearsed(typed_.composition),
                                     typed_.folder, "")(staff_names);
    if (!names) {
      out_ << to_string(names.error()) << '\n';
      return false;
    }
    auto some = *names;
    some.resize(std::min(some.size(), names_tried));
    return rows.names(one_in(some, options_.one_in));
  }

  bool conversations(const ConversationRow& row) {
    auto suite = read_suite(typed_, {}, places_);
    if (!suite) {
      out_ << to_string(suite.error()) << '\n';
      return false;
    }
    suite->conversations = one_in(suite->conversations, options_.one_in);
    VoiceWish wish;
    wish.voices = options_.voices;
    wish.noise = row.noise;
    wish.told = options_.told;
    const auto results =
        hold_by_voices(typed_, spoken_, *suite, wish, typed_.plugins);
    if (!results) {
      out_ << fmt::format("{:<10} {}\n", row.name, to_string(results.error()));
      return false;
    }
    if (options_.trace)
      print_rows(out_, *results, false);
    print_conversations(row, wish, *results, out_);
    return true;
  }

  const Places& places_;
  const SpeechBenchOptions& options_;
  std::ostream& out_;
  const Application& typed_;
  const Application& spoken_;
  SpeechBank bank_;
  Sentences sentences_;
};

} // namespace

std::vector<std::string> speech_bench_rows() {
  std::vector<std::string> rows{"load", "detector", "foreign", "names",
                                "digits"};
  for (const auto& row : conversation_rows())
    rows.push_back(row.name);
  return rows;
}

bool speech_bench(const Places& places, const SpeechBenchOptions& options,
                  const Console& console) {
  const auto typed = open_application(places, "receptionist", console);
  if (std::holds_alternative<int>(typed))
    return false;
  VoiceWishes seat{"user.wav", "robot.wav"};
  seat.recogniser = options.recogniser;
  const auto spoken = open_application(places, "receptionist", console, seat);
  if (std::holds_alternative<int>(spoken))
    return false;
  return Table(places, options, console, std::get<Application>(typed),
               std::get<Application>(spoken))
      .print();
}

} // namespace parlour::tools
