#include "adapters/asr/moonshine_asr.hpp"

#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "adapters/asr/moonshine_grammars.hpp"
#include "adapters/asr/moonshine_place.hpp"
#include "adapters/asr/moonshine_program.hpp"
#include "adapters/asr/moonshine_text.hpp"
#include "adapters/asr/moonshine_turns.hpp"
#include "adapters/asr/moonshine_words.hpp"
#include "adapters/asr/sphinx/language_sources.hpp"
#include "adapters/loop/loop.hpp"
#include "adapters/nlu/values/known_columns.hpp"
#include "runtime/plugin/adaptors.hpp"
#include "runtime/plugin/open_messages.hpp"

namespace parlour::adapters {

namespace {

using namespace moonshine;

// Whose grammars are kept; beyond it all are forgotten, and the next turns
// prefer all words.
constexpr std::size_t most_sessions = 1'000;

using Folders = std::vector<std::filesystem::path>;

std::vector<OptionDescription> option_descriptions() {
  std::vector<OptionDescription> all{
      {"program", "",
       "the file moonshine.mjs; its packages are beside it. Otherwise the one "
       "that comes with Parlour"},
      {"node", "node", "Node.js, a name or a path"},
      {"network",
       "base",
       "base hears better; tiny takes two thirds of its time and less memory",
       false,
       OptionType::choice,
       {"base", "tiny"}},
      {"timeout", "10s", "how long a result may take, else it is started again",
       false, OptionType::duration}};
  const auto& language = asr::language_options();
  all.insert(all.end(), language.begin(), language.end());
  all.push_back({"any-words", "false",
                 "hears also what is far from anything that the application "
                 "expects",
                 false, OptionType::boolean});
  all.push_back({"one-by-one", "false",
                 "answers each message before the next; virtual time sets it",
                 false, OptionType::boolean});
  return all;
}

const auto options = option_descriptions();

// Threads: commands come on the plug-in's own thread; answers of the program
// come on its loop's thread; grammars are prepared on a thread of their own.
//
// The program is sent everything as it comes and decides by itself when it
// works; here is only known which turn belongs to which message.
class MoonshineASR : public ASRPlugin {
public:
  explicit MoonshineASR(Folders programs) : programs_(std::move(programs)) {}
  void stop() override;

private:
  Expected<void> on_start(const Options& given) override;
  void on_do_recognition(const Binary& audio) override;
  void on_finish() override;
  void on_cancel() override;
  void on_set_grammar(const List& names) override;
  void on_set_values(const std::string& column, const List& values) override;

  Expected<ProgramOrder> program_order(const Options& given) const;
  ProgramCalls calls();
  ColumnReader columns();
  void tell_words();
  void prepare_grammars();
  void make_grammars();
  const std::vector<std::string>& wanted_in(const SessionId& session) const;
  void narrow(TurnNumber turn, const SessionId& session);
  void take(const Answer& answer);
  std::string typed(std::string_view text);
  List typed(List entries);
  void tell_partial(const Answer& answer);
  void tell_result(const Message& order, const Answer& answer);
  void reject(const Message& order, const std::string& reason);
  void program_ended(const std::string& reason);
  void end(const std::string& reason);

  const Folders programs_;
  bool one_by_one_ = false;
  bool any_words_ = false;
  OpenMessages open_;
  // Of the columns: taken by the thread that prepares the grammars, too.
  std::mutex columns_mutex_;
  nlu::KnownColumns columns_;
  asr::LanguageSources sources_;
  std::mutex mutex_; // of what follows
  MoonshineTurns turns_;
  std::optional<MoonshineGrammars> grammars_; // once they are prepared
  std::map<SessionId, std::vector<std::string>> wanted_;
  // Why the program has ended; empty while it runs.
  std::string ended_;
  // Destroyed first: they call.
  std::unique_ptr<MoonshineProgram> program_;
  std::unique_ptr<Loop> loop_;
};

Expected<ProgramOrder> MoonshineASR::program_order(const Options& given) const {
  const auto* const path = std::getenv("PATH");
  return find_place({option_value(given, options, "program"), programs_,
                     option_value(given, options, "node"), path ? path : ""})
      .map([&](const Place& place) {
        ProgramOrder order;
        order.program = place.node;
        order.arguments = {place.program.string(), "--network",
                           option_value(given, options, "network")};
        order.answer_within =
            *parse_duration(option_value(given, options, "timeout"));
        return order;
      });
}

Expected<void> MoonshineASR::on_start(const Options& given) {
  any_words_ = option_value(given, options, "any-words") == "true";
  one_by_one_ = option_value(given, options, "one-by-one") == "true";
  auto sources = asr::language_sources(host(), given);
  if (!sources)
    return tl::make_unexpected(sources.error());
  sources_ = std::move(*sources);
  sources_.columns = columns();
  const auto order = program_order(given);
  if (!order)
    return tl::make_unexpected(order.error());
  auto program = MoonshineProgram::start(*order, calls());
  if (!program)
    return fail(program.error().kind,
                "the recogniser's program " + order->arguments.front() +
                    " does not start: " + program.error().message);
  program_ = std::move(*program);
  tell_words();
  prepare_grammars();
  return {};
}

ColumnReader MoonshineASR::columns() {
  return [this](const std::string& name) {
    const std::lock_guard lock(columns_mutex_);
    return columns_.read(name, [this](const std::string& column) {
      return host().column(column);
    });
  };
}

// The newest words take the place of those before.
void MoonshineASR::tell_words() {
  program_->send(words_frame(application_words(host(), sources_.columns)));
}

// Takes a second or less; meanwhile nothing is narrowed, or by old values.
void MoonshineASR::prepare_grammars() {
  if (one_by_one_)
    return make_grammars();
  if (!loop_) {
    auto loop =
        Loop::start([this](const std::string& what) { host().log(what); });
    if (!loop)
      return host().log("Grammars cannot be prepared: " + loop.error().message);
    loop_ = std::move(*loop);
  }
  loop_->post([this] { make_grammars(); });
}

void MoonshineASR::make_grammars() {
  MoonshineGrammars made{asr::language_store().get(sources_)};
  for (auto& frame : language_frames(made.domain_model(), !any_words_))
    program_->send(std::move(frame));
  const std::lock_guard lock(mutex_);
  grammars_ = std::move(made);
}

ProgramCalls MoonshineASR::calls() {
  return {[this](const Answer& answer) { take(answer); },
          [this](Milliseconds time) {
            host().log("The recogniser is ready, after " +
                       std::to_string(time.count()) + " ms.");
          },
          [this](const std::string& reason) { program_ended(reason); },
          [this](const std::string& line) { host().log(line); }};
}

void MoonshineASR::stop() {
  loop_.reset(); // it may be preparing grammars
  program_.reset();
  end("The component is stopped.");
}

// A turn is narrowed before its first audio, as the program wants it.
void MoonshineASR::on_do_recognition(const Binary&) {
  const auto message = current();
  const auto samples = speech_samples(message.params.at(0));
  if (!samples)
    return refuse(samples.error().message);
  const std::lock_guard lock(mutex_);
  if (!ended_.empty() || samples->empty())
    return;
  const auto place = turns_.add(message, samples->size());
  if (place.dropped)
    program_->send(cancel_frame(*place.dropped));
  if (place.is_new)
    narrow(place.turn, message.session);
  if (place.samples > 0)
    program_->send(audio_frame(place.turn, samples->first(place.samples)));
}

// The program is asked under the lock: what ends it meanwhile finds the turn,
// and rejects it.
void MoonshineASR::on_finish() {
  {
    const std::lock_guard lock(mutex_);
    if (!ended_.empty())
      return fire_rejected(ended_);
    if (!turns_.has_room())
      return fire_rejected("Too many turns wait for the recogniser.");
    const auto turn = turns_.finish(current());
    if (!turn)
      return fire_rejected("Nothing was heard.");
    open_.open();
    program_->ask(*turn, finish_frame(*turn));
  }
  if (one_by_one_)
    open_.wait_for_all();
}

// Answers are fired without the lock: the plug-in's host may call back.
void MoonshineASR::on_cancel() {
  MoonshineTurns::Cancelled cancelled;
  {
    const std::lock_guard lock(mutex_);
    cancelled = turns_.cancel(current().session);
    if (ended_.empty())
      for (const auto turn : cancelled.turns)
        program_->send(cancel_frame(turn));
  }
  for (const auto& order : cancelled.orders)
    reject(order, "The turn is cancelled.");
}

// From the session's next turn on.
void MoonshineASR::on_set_grammar(const List& names) {
  const std::lock_guard lock(mutex_);
  if (wanted_.size() >= most_sessions)
    wanted_.clear();
  auto& wanted = wanted_[current().session];
  wanted.clear();
  for (const auto& name : names)
    wanted.push_back(name.text());
  if (wanted.empty())
    wanted_.erase(current().session);
}

// All grammars: none is wanted.
const std::vector<std::string>&
MoonshineASR::wanted_in(const SessionId& session) const {
  static const std::vector<std::string> none;
  const auto found = wanted_.find(session);
  return found == wanted_.end() ? none : found->second;
}

// Nothing is sent where no wanted name is known: all words are preferred then.
void MoonshineASR::narrow(TurnNumber turn, const SessionId& session) {
  const auto& wanted = wanted_in(session);
  if (wanted.empty() || !grammars_)
    return;
  if (const auto* words = grammars_->words(wanted))
    program_->send(narrow_frame(turn, *words));
}

// A turn that is being recognised keeps the words with which that began.
// The words are told at once; the grammars follow when they are prepared.
void MoonshineASR::on_set_values(const std::string& column,
                                 const List& values) {
  {
    const std::lock_guard lock(columns_mutex_);
    if (!columns_.set(column, values))
      return;
  }
  {
    const std::lock_guard lock(mutex_);
    if (ended_.empty())
      tell_words();
  }
  prepare_grammars();
}

// -- on the thread of the program's loop --------------------------------------

// `ready` and `failed` do not come here (MoonshineProgram).
void MoonshineASR::take(const Answer& answer) {
  if (answer.kind == AnswerKind::partial)
    return tell_partial(answer);
  std::optional<Message> order;
  {
    const std::lock_guard lock(mutex_);
    order = turns_.take(answer.turn);
  }
  if (!order) // it was cancelled meanwhile
    return;
  if (answer.kind == AnswerKind::rejected)
    return reject(*order, answer.text);
  tell_result(*order, answer);
}

// As people type it, and the application writes names.
std::string MoonshineASR::typed(std::string_view text) {
  const std::lock_guard lock(mutex_);
  return grammars_ ? grammars_->typed(text) : typed_text(text);
}

// The texts of alternatives or of words.
List MoonshineASR::typed(List entries) {
  for (auto& entry : entries)
    entry = Map{{"text", typed(entry["text"].text())},
                {"confidence", entry["confidence"]}};
  return entries;
}

// Whether a sentence may end here is said only once the grammars are prepared.
void MoonshineASR::tell_partial(const Answer& one) {
  std::optional<MoonshineTurns::Partial> partial;
  std::optional<bool> ends;
  {
    const std::lock_guard lock(mutex_);
    partial = turns_.partial(one.turn);
    if (partial && grammars_)
      ends = grammars_->ends(wanted_in(partial->order.session), one.text);
  }
  if (!partial)
    return;
  std::vector<Value> params{typed(one.text), partial->revision};
  if (ends)
    params.emplace_back(*ends);
  answer(partial->order, "Partial", std::move(params));
}

void MoonshineASR::tell_result(const Message& order, const Answer& one) {
  const OpenMessages::Closing closing(open_);
  answer(order, "RecognitionResult",
         {typed(one.text), one.confidence, typed(one.alternatives),
          typed(one.words)});
}

void MoonshineASR::reject(const Message& order, const std::string& reason) {
  const OpenMessages::Closing closing(open_);
  answer(order, "Rejected", {reason});
}

// First the waiting turns are rejected, then the supervisor replaces the
// instance.
void MoonshineASR::program_ended(const std::string& reason) {
  const auto sentence = "The recogniser's program has ended: " + reason;
  end(sentence);
  host().failed(sentence);
}

// From now on everything is rejected for this reason.
void MoonshineASR::end(const std::string& reason) {
  std::vector<Message> orders;
  {
    const std::lock_guard lock(mutex_);
    ended_ = reason;
    orders = turns_.take_all();
  }
  for (const auto& order : orders)
    reject(order, reason);
}

} // namespace

PluginFactory moonshine_asr_factory(Folders programs) {
  PluginDescription description;
  description.name = "MoonshineASR";
  description.roles = {"ASR"};
  description.sentence =
      "hears English, any words; a neural network, offline; needs Node.js";
  description.options = options;
  return {std::move(description), [programs = std::move(programs)] {
            return std::make_unique<MoonshineASR>(programs);
          }};
}

} // namespace parlour::adapters
