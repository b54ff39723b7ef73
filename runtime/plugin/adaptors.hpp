// The tailored adaptors (paper III.D): what a plug-in of a role derives from
// instead of IPlugin. The role's commands arrive as calls, on_ and the
// command's name, with typed parameters; fire_ and the event's name answers.
// What is missing or does not fit never arrives: it is refused.
//
// An answer that takes longer: keep current(), and later fire within
// as_answer_to(kept, …).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/plugin/role_plugin.hpp"

namespace parlour {

// A microphone.
class MicrophonePlugin : public RolePlugin {
protected:
  MicrophonePlugin();

  // Ends with fire_started or fire_failed.
  virtual void on_start_mic() = 0;
  // Ends with fire_stopped.
  virtual void on_stop_mic() = 0;
  // Samples a second, and channels.
  virtual void on_set_format(std::int64_t rate, std::int64_t channels);

  // Position in ms since the microphone was started. From any thread of the
  // plug-in: audio answers nobody.
  void fire_buffer_full(Binary audio, std::int64_t position);
  void fire_started();
  void fire_stopped();
  void fire_failed(std::string reason);
};

// A voice activity detector.
class VADPlugin : public RolePlugin {
protected:
  VADPlugin();

  virtual void on_process(const Binary& audio) = 0;
  // What comes next has nothing to do with what came before.
  virtual void on_reset() = 0;

  // Positions in ms since the last reset.
  void fire_speech_started(std::int64_t position);
  void fire_speech_ended(std::int64_t position);
};

// A recogniser.
class ASRPlugin : public RolePlugin {
protected:
  ASRPlugin();

  // The next piece of what is said.
  virtual void on_do_recognition(const Binary& audio) = 0;
  // That was all: ends with fire_result or fire_rejected.
  virtual void on_finish() = 0;
  // Nobody wants to know it any more.
  virtual void on_cancel() = 0;
  // Names of grammars, the only ones from now on.
  virtual void on_set_grammar(const List& names);

  // What it has heard so far; revisions count from 1.
  void fire_partial(std::string text, std::int64_t revision);
  // Confidence from 0 to 1, or unknown.
  void fire_result(std::string text, Value confidence, List alternatives = {},
                   List words = {});
  void fire_rejected(std::string reason);
};

// A synthesiser.
class TTSPlugin : public RolePlugin {
public:
  using Utterance = std::int64_t;

protected:
  TTSPlugin();

  // Ends with fire_finished, at once or later.
  virtual void on_speak(const std::string& text, Utterance utterance,
                        std::optional<bool> interruptible) = 0;
  // That utterance, or all; one that is stopped is finished, too.
  virtual void on_stop(std::optional<Utterance> utterance) = 0;
  virtual void on_set_voice(const std::string& name);

  void fire_audio(Binary audio, Utterance utterance);
  // The word begins at that position in the audio, in ms.
  void fire_mark(Utterance utterance, std::string word, std::int64_t position);
  void fire_finished(Utterance utterance);
};

// An understanding, asked in a session's own turn, by several threads at once,
// where its description says that it is inline.
class NLUPlugin : public InlinePlugin {
public:
  std::vector<Answer> answers(const Message& message) const final;

protected:
  // The acts in what was said, the most certain first; none: it was not
  // understood. `context` is what the dialogue expects (understanding.md).
  virtual std::vector<Value> understand(const std::string& text,
                                        const Map& context) const = 0;
};

// Words for acts; inline like an NLU.
class NLGPlugin : public InlinePlugin {
public:
  std::vector<Answer> answers(const Message& message) const final;

protected:
  // The words for an act (a map) or for a text; nothing where it has none.
  virtual std::optional<std::string> generate(const Value& what,
                                              const Value& data) const = 0;
};

// A database. Each command ends with fire_result or fire_error. A transaction
// belongs to the session of the message that begins it (current()).
class DatabasePlugin : public RolePlugin {
protected:
  DatabasePlugin();

  // Is it there?
  virtual void on_connect(std::optional<Value> options) = 0;
  // Values are bound, never pasted; `write` where it may change something.
  virtual void on_query(const std::string& sql, const List& values,
                        std::optional<bool> write) = 0;
  virtual void on_begin() = 0;
  virtual void on_commit() = 0;
  virtual void on_rollback() = 0;

  void fire_result(ResultSet rows = {});
  void fire_error(const Error& error);
};

// A source of answers that is no database.
class KnowledgePlugin : public RolePlugin {
protected:
  KnowledgePlugin();

  // Ends with fire_result. `question` is a text, or the slots that are asked
  // by as a map.
  virtual void on_ask(const std::string& source, const Value& question) = 0;

  // What it knows, what was asked for in the end, and what was left out to
  // find anything at all.
  void fire_result(ResultSet rows, Value asked = {}, List relaxed = {});
};

} // namespace parlour
