// What an act says as a value, for the message that carries it to the session.
#pragma once

#include "adapters/nlu/parse/built_act.hpp"

namespace parlour::adapters::nlu {

// The act as a map, as FrameInfo carries it
// (runtime/message/understanding.hpp).
Map act_value(const BuiltAct& act, const Utterance& utterance,
              const Spans& spans, const Schema& schema);

} // namespace parlour::adapters::nlu
