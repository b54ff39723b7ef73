// A queue of utterances, of which the first is being spoken. A timer stands for
// each word; when the last one has passed, the utterance is finished and the
// next one begins.
#include "adapters/tts/text_file_tts.hpp"

#include <filesystem>
#include <ostream>
#include <utility>

#include "runtime/base/outside/file_bytes.hpp"
#include "runtime/plugin/option_reader.hpp"
#include "runtime/text/words.hpp"

namespace parlour::adapters {

namespace {

// Bounds the queue.
constexpr std::size_t max_waiting = 100;

const std::vector<OptionDescription>& option_descriptions() {
  static const std::vector<OptionDescription> options = {
      {"file", "speech.txt", "the file, in the data folder"},
      {"rate", "180", "words a minute; 0 takes no time", false,
       OptionType::number}};
  return options;
}

Value param(const Message& message, std::size_t index) {
  return index < message.params.size() ? message.params[index] : Value();
}

std::string text_param(const Message& message, std::size_t index) {
  const auto value = param(message, index);
  return value.is_unknown() ? std::string() : value.text();
}

// A line break within the text would look like a second utterance.
std::string in_one_line(const std::string& text) {
  std::string line;
  for (const auto& word : split_words(text))
    line += (line.empty() ? "" : " ") + word;
  return line;
}

} // namespace

Expected<void> TextFileTTS::on_start(const Options& options) {
  OptionReader read(options, option_descriptions());
  const auto a_minute = read.number("rate", 0, 10'000);
  word_time_ = Milliseconds(
      a_minute > 0 ? static_cast<std::int64_t>(60'000 / a_minute) : 0);
  const auto path = read.file("file", host().data_folder());
  if (auto outcome = read.outcome(); !outcome)
    return outcome;
  if (auto file = check_may_be_file(path); !file)
    return file;
  std::error_code ignored;
  std::filesystem::create_directories(path.parent_path(), ignored);
  file_.open(path, std::ios::app);
  if (!file_)
    return fail(ErrorKind::file, "cannot be written", {path.string(), 0, 0});
  return {};
}

void TextFileTTS::stop() {
  if (delay_ != 0)
    host().cancel(std::exchange(delay_, 0));
  waiting_.clear();
  file_.close();
}

void TextFileTTS::on_message(const Message& message) {
  if (message.command == "Speak")
    speak(message);
  else if (message.command == "Stop")
    stop_speaking(message.session, param(message, 0));
  else if (message.command == "SetVoice")
    voice_ = in_one_line(text_param(message, 0));
  else
    fire_event("Failed", {"TextFileTTS does not know the command '" +
                          message.command + "'."});
}

void TextFileTTS::speak(const Message& order) {
  if (waiting_.size() >= max_waiting)
    return fire_event("Failed", {"There is too much to say already."});
  waiting_.push_back({order, text_param(order, 0), param(order, 1)});
  if (waiting_.size() == 1)
    begin();
}

// Utterances without time, or without words, end at once; the loop goes on with
// the next.
void TextFileTTS::begin() {
  while (!waiting_.empty()) {
    write(waiting_.front());
    words_ = split_words(waiting_.front().text);
    spoken_ = 0;
    if (word_time_ > Milliseconds::zero() && !words_.empty())
      return next_word();
    end();
  }
}

void TextFileTTS::next_word() {
  delay_ = 0;
  // The mark is fired when a word begins, and the timer waits for its end.
  const auto& utterance = waiting_.front();
  if (spoken_ == words_.size()) {
    end();
    return begin();
  }
  const auto position = static_cast<std::int64_t>(spoken_) * word_time_.count();
  answer(utterance.order, "Mark",
         {utterance.name, words_[spoken_++], position});
  delay_ = host().after(word_time_, [this] { next_word(); });
}

// Ends the first utterance.
void TextFileTTS::end() {
  const auto utterance = std::move(waiting_.front());
  waiting_.pop_front();
  finish(utterance);
}

// Ends the utterances that are meant and keeps the others in order. If the
// first one was meant, the next one begins.
void TextFileTTS::stop_speaking(const SessionId& session,
                                const Value& utterance) {
  // Only utterances of the session that asks are meant.
  auto meant = [&](const Utterance& one) {
    return one.order.session == session &&
           (utterance.is_unknown() || one.name == utterance);
  };
  if (waiting_.empty())
    return;
  // Only the first utterance has a timer.
  const bool first = meant(waiting_.front());
  if (first && delay_ != 0)
    host().cancel(std::exchange(delay_, 0));
  auto before = std::exchange(waiting_, {});
  for (auto& one : before)
    if (meant(one))
      finish(one);
    else
      waiting_.push_back(std::move(one));
  if (first)
    begin();
}

void TextFileTTS::finish(const Utterance& utterance) {
  answer(utterance.order, "Finished", {utterance.name});
}

void TextFileTTS::write(const Utterance& utterance) {
  file_ << format_timestamp(host().clock().now(), "%H:%M:%S") << '\t'
        << (voice_.empty() ? "" : voice_ + ": ") << in_one_line(utterance.text)
        << std::endl;
  if (!file_)
    host().log("What was said could not be written.");
}

PluginFactory text_file_tts_factory() {
  PluginDescription description;
  description.name = "TextFileTTS";
  description.roles = {"TTS"};
  description.sentence = "writes to a file what a voice would speak, in its "
                         "time";
  description.options = option_descriptions();
  return {std::move(description),
          [] { return std::make_unique<TextFileTTS>(); }};
}

} // namespace parlour::adapters
