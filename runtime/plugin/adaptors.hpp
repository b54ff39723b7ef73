// Base classes for plug-ins of one role. A plug-in derives from the class of
// its role instead of IPlugin: each command of the role arrives as a call of
// on_ plus the command's name, with typed parameters, and fire_ plus an event's
// name answers it. A command whose parameters are missing or of the wrong type
// is refused before the plug-in sees it.
//
// A plug-in that answers later keeps a copy of current(), and fires within
// as_answer_to(kept, …). An example of a whole plug-in is in docs/plugins.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/plugin/role_plugin.hpp"

namespace parlour {

// Captures audio from a device and fires it in small buffers.
class MicrophonePlugin : public RolePlugin {
protected:
  MicrophonePlugin();

  // Starts capturing. End it with fire_started or fire_failed.
  virtual void on_start_mic() = 0;
  // Stops capturing. End it with fire_stopped.
  virtual void on_stop_mic() = 0;
  // Sets the sample rate in Hz and the number of channels. Refuses unless
  // overridden.
  virtual void on_set_format(std::int64_t rate, std::int64_t channels);

  // `position` is the time in ms since the microphone was started. May be
  // called from any thread, because audio is no answer to a command.
  void fire_buffer_full(Binary audio, std::int64_t position);
  void fire_started();
  void fire_stopped();
  void fire_failed(std::string reason);
};

// Detects where speech starts and ends in a stream of audio.
class VADPlugin : public RolePlugin {
protected:
  VADPlugin();

  // `position` is where the audio begins, in ms since the microphone was
  // started. Without it the audio follows on what came before.
  virtual void on_process(const Binary& audio,
                          std::optional<std::int64_t> position) = 0;
  // What the loudspeaker plays now. Ignored unless overridden.
  virtual void on_set_echo(const Binary& audio);
  // The next audio has nothing to do with what came before.
  virtual void on_reset() = 0;

  // Positions are where speech began or ended, not where that was noticed: in
  // ms as on_process has them, or since the last reset.
  void fire_speech_started(std::int64_t position);
  void fire_speech_ended(std::int64_t position);
};

// A speech recogniser: turns audio into text.
class ASRPlugin : public RolePlugin {
protected:
  ASRPlugin();

  // The next piece of the utterance.
  virtual void on_do_recognition(const Binary& audio) = 0;
  // The utterance is complete. End it with fire_result or fire_rejected.
  virtual void on_finish() = 0;
  // The result is no longer needed.
  virtual void on_cancel() = 0;
  // Expects only these grammars from now on. Ignored unless overridden.
  virtual void on_set_grammar(const List& names);
  // The column ("db:staff.name") has these values from now on. Ignored unless
  // overridden.
  virtual void on_set_values(const std::string& column, const List& values);

  // The text recognised so far; revisions count from 1. `ends` tells whether a
  // sentence may end there, if the recogniser knows.
  void fire_partial(std::string text, std::int64_t revision,
                    std::optional<bool> ends = {});
  // The confidence is between 0 and 1, or unknown.
  void fire_result(std::string text, Value confidence, List alternatives = {},
                   List words = {});
  void fire_rejected(std::string reason);
};

// A speech synthesiser: turns text into audio.
class TTSPlugin : public RolePlugin {
public:
  using Utterance = std::int64_t;

protected:
  TTSPlugin();

  // Starts to speak. End it with fire_finished, at once or later.
  virtual void on_speak(const std::string& text, Utterance utterance,
                        std::optional<bool> interruptible) = 0;
  // Stops one utterance, or all. An utterance that is stopped is finished, too:
  // fire_finished is due for it.
  virtual void on_stop(std::optional<Utterance> utterance) = 0;
  virtual void on_set_voice(const std::string& name);

  void fire_audio(Binary audio, Utterance utterance);
  // The word begins at this position of the utterance's audio, in ms.
  void fire_mark(Utterance utterance, std::string word, std::int64_t position);
  void fire_finished(Utterance utterance);
};

// Language understanding: turns text into dialogue acts. It is called in the
// session's own turn and by several threads at once if its description says
// is_inline; what it reads must not change but as a whole.
class NLUPlugin : public InlinePlugin {
public:
  std::vector<Answer> answers(const Message& message) const final;

protected:
  // The acts in the text, the most certain first; empty if nothing was
  // understood. runtime/message/understanding.hpp describes an act and
  // `context`, which is what the dialogue expects.
  virtual std::vector<Value> understand(const std::string& text,
                                        const Map& context) const = 0;
  // The column ("db:staff.name") has these values from now on. Ignored unless
  // overridden. It may come in the turns of several sessions at once, while
  // others call understand().
  virtual void set_values(const std::string& column, const List& values) const;
};

// Language generation: turns acts into words. Called like an NLUPlugin.
class NLGPlugin : public InlinePlugin {
public:
  std::vector<Answer> answers(const Message& message) const final;

protected:
  // The words for an act (a map) or for a text; nothing if it has none.
  virtual std::optional<std::string> generate(const Value& what,
                                              const Value& data) const = 0;
};

// A database. End each command with fire_result or fire_error. A transaction
// belongs to the session of the message that begins it (current().session).
class DatabasePlugin : public RolePlugin {
protected:
  DatabasePlugin();

  // Checks that the database can be reached.
  virtual void on_connect(std::optional<Value> options) = 0;
  // Runs one statement. The values must be bound as parameters, never pasted
  // into the text. `write` tells whether the statement may change data.
  virtual void on_query(const std::string& sql, const List& values,
                        std::optional<bool> write) = 0;
  virtual void on_begin() = 0;
  virtual void on_commit() = 0;
  virtual void on_rollback() = 0;

  void fire_result(ResultSet rows = {});
  void fire_error(const Error& error);
};

// A source of answers that is not a database.
class KnowledgePlugin : public RolePlugin {
protected:
  KnowledgePlugin();

  // Ends with fire_result. `question` is a text, or a map of the slots that the
  // question gives.
  virtual void on_ask(const std::string& source, const Value& question) = 0;

  // The rows found, the question that was answered in the end, and the
  // conditions that were left out to find any rows.
  void fire_result(ResultSet rows, Value asked = {}, List relaxed = {});
};

} // namespace parlour
