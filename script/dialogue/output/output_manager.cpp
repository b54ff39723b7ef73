#include "script/dialogue/output/output_manager.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "script/dialogue/output/unheard_part.hpp"

namespace parlour::dialogue {

using namespace std::string_view_literals;

namespace {

const std::string language_generation = "NLG";

// Times in a row (engine rule 3.7): a door that bangs again and again must not
// keep the robot at the same sentence for ever.
constexpr int max_taken_up = 3;

// Told of in one robot turn.
constexpr std::size_t max_failed_phrases = 100;

} // namespace

// The parameter of Generate: a text as it is, or the map that phrases see.
// `rotation` begins at another wording for each seed and goes on by one with
// each use, so that two sessions differ and a replay does not.
Value OutputManager::generate_params(const Say& what) {
  if (!what.text.empty())
    return what.text;
  const auto& program = *context_.program;
  Map say;
  say.set("act", what.act);
  if (what.topic != script::no_id) {
    const auto& topic = program.topics[what.topic];
    say.set("topic", topic.name);
    if (what.slot != script::no_id)
      say.set("slot", topic.slots[what.slot].name);
  }
  say.set("data", what.data);
  auto key = what.act + "/" + Value(say)["topic"].text();
  say.set("rotation",
          static_cast<std::int64_t>(context_.options.seed) - 1 + uses_[key]++);
  say.set("now", context_.now);
  return say;
}

OutputId OutputManager::say(Say&& what) {
  if (!context_.port.reachable(language_generation)) {
    auto text = what.text.empty() ? words_of(generate_params(what), what.turn)
                                  : std::move(what.text);
    return text.empty()
               ? 0
               : push(what.as, std::move(text), what, OutputState::pending);
  }
  auto params = generate_params(what);
  auto id = push(what.as, {}, what, OutputState::worded);
  ask_for_words(id, std::move(params), what.turn);
  return id;
}

// An inline NLG component has answered by the time that post() returns; then
// there is nothing to wait for, and no timer.
void OutputManager::ask_for_words(OutputId id, Value params, TurnId turn) {
  const auto& settings = context_.program->settings.sessions;
  const auto correlation =
      messenger_.post(language_generation, "Generate", {params}, turn);
  wording_[correlation] = {id, std::move(params), 0};
  if (!messenger_.is_answered(correlation))
    wording_[correlation].timer = timers_.start(
        context_.in(settings.request_timeout),
        {.purpose = Timer::Purpose::wording, .correlation = correlation});
}

// Nothing is said where the application has no phrase for it.
std::string OutputManager::words_of(const Value& params, TurnId turn) {
  if (const auto* text = params.if_string())
    return *text;
  const auto* phrases = context_.options.phrases.get();
  auto [words, failures] = phrases ? phrases->render(params) : Rendering{};
  for (const auto& failure : failures)
    phrase_failed(failure, turn);
  if (!words)
    context_.inspect(InspectionKind::error, params["act"].text(),
                     "there is no phrase for it");
  return std::move(words).value_or("");
}

bool OutputManager::hear_failure(const Message& event, TurnId turn) {
  if (event.command != "PhraseFailed"sv ||
      !context_.port.is_source(language_generation, event.source))
    return false;
  const Value params(event.params);
  const auto line = params.at(2).integer_or(0);
  phrase_failed({ErrorKind::thrown,
                 params.at(0).text(),
                 {params.at(1).text(), static_cast<std::uint32_t>(line)}},
                turn);
  return true;
}

// Another phrase was taken in its place: where nobody listens, the user need
// not hear of it.
void OutputManager::phrase_failed(const Error& error, TurnId turn) {
  context_.inspect(InspectionKind::error, "phrase", to_string(error));
  const auto told = std::ranges::find(failed_phrases_, error.place);
  if (told != failed_phrases_.end() ||
      failed_phrases_.size() == max_failed_phrases ||
      !reactions_.listens("Script", "Error"))
    return;
  failed_phrases_.push_back(error.place);
  messenger_.raise_error(error, turn);
}

OutputId OutputManager::push(OutputAct as, std::string text, const Say& what,
                             OutputState state) {
  Output output;
  output.act = as;
  output.text = std::move(text);
  output.topic = what.topic;
  output.slot = what.slot;
  output.turn = what.turn;
  output.state = state;
  output.awaited = what.awaited;
  output.interruptible = what.interruptible;
  ++made_;
  told_ += as == OutputAct::answer ? 1 : 0;
  changed_ = true;
  return queue_.push(std::move(output));
}

// `handled` is the correlation of the message that the script handles: if that
// is the answer to a Generate, the text words its entry and is no output of its
// own.
OutputId OutputManager::speak(std::string text, Correlation handled,
                              TurnId turn, bool interruptible) {
  if (auto found = wording_.find(handled); found != wording_.end()) {
    auto id = found->second.output;
    timers_.cancel(found->second.timer);
    wording_.erase(found);
    word(id, std::move(text));
    return id;
  }
  Output output;
  output.text = std::move(text);
  output.turn = turn;
  output.interruptible = interruptible;
  ++made_;
  ++told_;
  changed_ = true;
  return queue_.push(std::move(output));
}

void OutputManager::word(OutputId id, std::string text) {
  const bool dropped = text.empty();
  queue_.word(id, std::move(text));
  changed_ = true;
  if (dropped)
    question_.unspoken(id);
}

// A handler's <speak> has removed the entry from `wording_` already. If it is
// still there, the event's own words count, or none if a handler took the event
// without speaking.
void OutputManager::handled(const Message& event, bool taken) {
  if (wording_.empty() || !wording_.contains(event.correlation))
    return;
  if (event.command != "Speak") {
    if (context_.port.reply_to_request(event) != Reply::none)
      give_up_wording(event.correlation);
    return;
  }
  auto text = !taken && !event.params.empty() ? event.params[0].text() : "";
  speak(std::move(text), event.correlation, 0, true);
}

void OutputManager::drop(const Input& input) {
  context_.turns.let_go(input.turn);
  handled(*input.message, false);
}

void OutputManager::give_up_wording(Correlation correlation) {
  auto found = wording_.find(correlation);
  if (found == wording_.end())
    return;
  auto text = words_of(found->second.params, 0);
  speak(std::move(text), correlation, 0, true);
}

// The seat before may have shown the words or not, so they are shown again; to
// hear a question twice is better than never.
void OutputManager::resume() {
  ask_again_for_words();
  for (const auto& [id, interruptible] : std::exchange(playing_, {}))
    if (const auto* output = queue_.released(id)) {
      inspect(*output, "said again");
      playing_.push_back({id, interruptible});
      context_.port.release(*output);
      voice(*output);
    }
}

// Who worded them does not know of it any more, unless the answer has come. A
// new correlation takes the old one's place, and the turn is asked for under
// the new one only.
void OutputManager::ask_again_for_words() {
  std::vector<Correlation> asked;
  for (const auto& [correlation, wording] : wording_)
    if (!messenger_.is_answered(correlation))
      asked.push_back(correlation);
  for (auto before : asked) {
    if (!context_.port.reachable(language_generation)) {
      give_up_wording(before);
      continue;
    }
    auto wording = std::move(wording_.extract(before).mapped());
    timers_.cancel(wording.timer);
    ask_for_words(wording.output, std::move(wording.params),
                  context_.turns.of(before));
    context_.turns.answered(before);
  }
}

// A question of a <confirm> (`awaited`) is asked in the turn that its script
// works for: only other turns withdraw it (engine rule 3.5).
bool OutputManager::release() {
  changed_ = false;
  const bool begun = context_.turns.any_open(context_.now);
  auto result = queue_.release([&](const Output& output) {
    return begun && (!output.awaited ||
                     context_.turns.any_open(context_.now, output.turn));
  });
  for (const auto& output : result.withdrawn) {
    inspect(output, "withdrawn");
    question_.withdrawn(output);
  }
  if (!result.released.empty())
    silent_since_.reset();
  for (const auto& output : result.released) {
    inspect(output, "released");
    playing_.push_back({output.id, output.interruptible});
    question_.released(output);
    context_.port.release(output);
    voice(output);
  }
  return !result.released.empty();
}

// What is shown is spoken too, where there is a voice.
void OutputManager::voice(const Output& output) {
  if (context_.port.reachable("TTS"))
    messenger_.post("TTS", "Speak",
                    {output.text, static_cast<std::int64_t>(output.id),
                     output.interruptible},
                    0);
}

void OutputManager::event_begins() {
  const auto enough = context_.program->settings.sessions.no_input_after;
  if (silent_since_ && context_.now - *silent_since_ >= enough.count())
    turn_begins();
}

void OutputManager::withdraw_questions() {
  for (const auto& output : queue_.withdraw_questions()) {
    inspect(output, "withdrawn");
    question_.withdrawn(output);
    changed_ = true; // what waited behind it may go now
  }
}

void OutputManager::repeat_last(TurnId turn) {
  for (const auto& text : queue_.last_turn()) {
    Say what;
    what.as = OutputAct::chat;
    what.turn = turn;
    push(what.as, text, what, OutputState::pending);
  }
}

void OutputManager::finished(OutputId id) {
  no_longer_playing(id);
  taken_up_ = 0;
}

void OutputManager::voice_failed() {
  playing_.clear();
}

bool OutputManager::is_voiced() const {
  return context_.port.reachable("TTS") && context_.port.reachable("Speaker");
}

void OutputManager::no_longer_playing(OutputId id) {
  std::erase_if(playing_,
                [&](const Playing& output) { return output.id == id; });
}

// An answer goes on behind the words that were heard; what was heard to its end
// needs no more.
void OutputManager::interrupted(OutputId id, const std::string& heard) {
  no_longer_playing(id);
  auto cut = queue_.cut(id, heard);
  if (!cut)
    return;
  inspect(*cut, "broken off");
  question_.broken_off(*cut, heard);
  if (cut->act == OutputAct::answer) // a question is asked again as a whole
    cut->text = unheard_part(cut->text, heard);
  if (!cut->text.empty())
    interrupted_.push_back(std::move(*cut));
}

// Each is another output with the rest of the words; together they are another
// robot turn. A question that is said again is the one that waits (said_again).
void OutputManager::take_up_interrupted() {
  auto again = std::exchange(interrupted_, {});
  if (again.empty() || taken_up_ == max_taken_up)
    return;
  ++taken_up_;
  turn_begins();
  for (auto& output : again) {
    Say what;
    what.as = output.act;
    what.topic = output.topic;
    what.slot = output.slot;
    what.turn = output.turn;
    what.awaited = output.awaited;
    what.interruptible = output.interruptible;
    question_.said_again(output.id, push(what.as, std::move(output.text), what,
                                         OutputState::pending));
  }
}

bool OutputManager::can_be_interrupted() const {
  return std::any_of(
      playing_.begin(), playing_.end(),
      [](const Playing& output) { return output.interruptible; });
}

bool OutputManager::silent() const {
  return queue_.empty() && playing_.empty();
}

void OutputManager::inspect(const Output& output, const char* what) {
  if (!context_.port.inspected())
    return;
  auto subject = output.topic == script::no_id
                     ? std::string()
                     : context_.topic(output.topic).name;
  context_.inspect(InspectionKind::output, subject,
                   std::string(what) + ": " + output.text);
}

} // namespace parlour::dialogue
