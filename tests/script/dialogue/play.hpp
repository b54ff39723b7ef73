// A play: a script whose comments are a conversation with it, taken in order:
//
//   <!-- start: Welcome -->           the settings' start
//   <!-- settings: <limits …/> -->    further children of <settings>
//   <!-- sessions: closes-after="9s" --> attributes of its <sessions>
//   <!-- component: Exchange Telephone --> a component and its roles
//   <!-- say: inform Taxi Time=3pm --> an act of the user, its topic (- where
//   it does not say), its slots; Time=3pm~0.5 is not sure, _ stands for a
//   blank, Person=Ann|Ben may be either, the words `elliptical` and `sure` say
//   that it is; Items=tea*2 is one of several values, Items=tea*1more one more
//   of it; further acts of the same utterance after a + each
//   <!-- breath: confirm -->          the same, and the next `say` or `breath`
//   follows before anything is made of it
//   <!-- event: Bell.Rings a b -->    an event; parameters are texts
//   <!-- broadcast: Bell.Rings a --> one that belongs to no session
//   <!-- reply: Exchange.Busy a -->   one that answers the last message
//   <!-- rows: name; Ann; Ben -->     what the database gives from now on
//   <!-- fails: Timeout it is gone --> with what kind and words it fails
//   <!-- wait: 2s -->                 time passes
//
//   <!-- said: text -->               the next thing that was said
//   <!-- interruptible: false -->     whether one may break into the last one
//   <!-- posted: Telephone.Call(1) --> the next message that was sent
//   <!-- asked: select … [Ann] -->    the next statement and its values
//   <!-- slot: Taxi.Time = 3pm -->    <!-- state: Welcome --> <!-- topic: Taxi
//   -->
//   <!-- error: text -->              the next error that was inspected, in
//   part
//   <!-- ended -->
//
// What was said, posted or asked and is not expected is a failure.
#pragma once

#include <filesystem>

namespace parlour::dialogue {

void expect_as_in_play(const std::filesystem::path& file);

} // namespace parlour::dialogue
