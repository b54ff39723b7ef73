// Each class registers its commands with the handlers and wraps its events. The
// names are those of roles.def; the parameters follow from the types.

#include "runtime/plugin/adaptors.hpp"

#include <utility>

namespace parlour {

// -- microphone --------------------------------------------------------------

MicrophonePlugin::MicrophonePlugin() : RolePlugin("Microphone") {
  on("start_mic", &MicrophonePlugin::on_start_mic);
  on("stop_mic", &MicrophonePlugin::on_stop_mic);
  on("SetFormat", &MicrophonePlugin::on_set_format);
}

void MicrophonePlugin::on_set_format(std::int64_t rate, std::int64_t channels) {
  refuse("the format " + std::to_string(rate) + " Hz, " +
         std::to_string(channels) + " channels cannot be had");
}

void MicrophonePlugin::fire_buffer_full(Binary audio, std::int64_t position) {
  answer({}, "BufferFull", {std::move(audio), position});
}

void MicrophonePlugin::fire_started() {
  fire_event("Started");
}

void MicrophonePlugin::fire_stopped() {
  fire_event("Stopped");
}

void MicrophonePlugin::fire_failed(std::string reason) {
  fire_event("Failed", {std::move(reason)});
}

// -- vad ---------------------------------------------------------------------

VADPlugin::VADPlugin() : RolePlugin("VAD") {
  on("Process", &VADPlugin::on_process);
  on("SetEcho", &VADPlugin::on_set_echo);
  on("Reset", &VADPlugin::on_reset);
}

void VADPlugin::on_set_echo(const Binary&) {}

void VADPlugin::fire_speech_started(std::int64_t position) {
  fire_event("SpeechStarted", {position});
}

void VADPlugin::fire_speech_ended(std::int64_t position) {
  fire_event("SpeechEnded", {position});
}

// -- asr ---------------------------------------------------------------------

ASRPlugin::ASRPlugin() : RolePlugin("ASR") {
  on("DoRecognition", &ASRPlugin::on_do_recognition);
  on("Finish", &ASRPlugin::on_finish);
  on("Cancel", &ASRPlugin::on_cancel);
  on("SetGrammar", &ASRPlugin::on_set_grammar);
  on("SetValues", &ASRPlugin::on_set_values);
}

void ASRPlugin::on_set_grammar(const List&) {}

void ASRPlugin::on_set_values(const std::string&, const List&) {}

void ASRPlugin::fire_partial(std::string text, std::int64_t revision,
                             std::optional<bool> ends) {
  std::vector<Value> params = {std::move(text), revision};
  if (ends)
    params.emplace_back(*ends);
  fire_event("Partial", std::move(params));
}

void ASRPlugin::fire_result(std::string text, Value confidence,
                            List alternatives, List words) {
  fire_event("RecognitionResult", {std::move(text), std::move(confidence),
                                   std::move(alternatives), std::move(words)});
}

void ASRPlugin::fire_rejected(std::string reason) {
  fire_event("Rejected", {std::move(reason)});
}

// -- tts ---------------------------------------------------------------------

TTSPlugin::TTSPlugin() : RolePlugin("TTS") {
  on("Speak", &TTSPlugin::on_speak);
  on("Stop", &TTSPlugin::on_stop);
  on("SetVoice", &TTSPlugin::on_set_voice);
}

void TTSPlugin::on_set_voice(const std::string& name) {
  refuse("there is no voice '" + name + "'");
}

void TTSPlugin::fire_audio(Binary audio, Utterance utterance) {
  fire_event("Audio", {std::move(audio), utterance});
}

void TTSPlugin::fire_mark(Utterance utterance, std::string word,
                          std::int64_t position) {
  fire_event("Mark", {utterance, std::move(word), position});
}

void TTSPlugin::fire_finished(Utterance utterance) {
  fire_event("Finished", {utterance});
}

// -- nlu ---------------------------------------------------------------------

// Inline plug-ins have no typed handlers: they answer from a const function,
// without the state that dispatching needs.
std::vector<Answer> NLUPlugin::answers(const Message& message) const {
  std::string text;
  if (message.command == "SetValues") {
    List values;
    if (message.params.size() > 1 && read(message.params[0], text) &&
        read(message.params[1], values))
      set_values(text, values);
    return {};
  }
  if (message.command != "DoNLU")
    return {{"Failed",
             {"NLU does not know the command '" + message.command + "'"}}};
  if (message.params.empty() || !read(message.params[0], text))
    return {{"NoResult", {""}}};
  Map context;
  if (message.params.size() > 1)
    read(message.params[1], context);
  auto acts = understand(text, context);
  if (acts.empty())
    return {{"NoResult", {std::move(text)}}};
  return {{"FrameInfo", std::move(acts)}};
}

void NLUPlugin::set_values(const std::string&, const List&) const {}

// -- nlg ---------------------------------------------------------------------

// Without words an empty text is still an answer, so that no request waits.
std::vector<Answer> NLGPlugin::answers(const Message& message) const {
  const auto& params = message.params;
  if (message.command != "Generate")
    return {{"Failed",
             {"NLG does not know the command '" + message.command + "'"}}};
  if (params.empty() || params[0].is_unknown())
    return {{"Failed", {"Generate takes a text or an act as its parameter 1"}}};
  auto words = generate(params[0], params.size() > 1 ? params[1] : Value());
  if (!words)
    return {{"Speak", {""}},
            {"NoPhrase", {params[0]["act"], params[0]["topic"]}}};
  return {{"Speak", {std::move(*words)}}};
}

// -- database ----------------------------------------------------------------

DatabasePlugin::DatabasePlugin() : RolePlugin("Database") {
  on("Connect", &DatabasePlugin::on_connect);
  on("Query", &DatabasePlugin::on_query);
  on("Begin", &DatabasePlugin::on_begin);
  on("Commit", &DatabasePlugin::on_commit);
  on("Rollback", &DatabasePlugin::on_rollback);
}

void DatabasePlugin::fire_result(ResultSet rows) {
  fire_event("Result", {std::move(rows)});
}

// The event Error carries the kind of the error and its message.
void DatabasePlugin::fire_error(const Error& error) {
  fire_event("Error", {name_of(error.kind), error.message});
}

// -- knowledge ---------------------------------------------------------------

KnowledgePlugin::KnowledgePlugin() : RolePlugin("Knowledge") {
  on("Ask", &KnowledgePlugin::on_ask);
}

void KnowledgePlugin::fire_result(ResultSet rows, Value asked, List relaxed) {
  fire_event("Result", {std::move(rows), std::move(asked), std::move(relaxed)});
}

} // namespace parlour
