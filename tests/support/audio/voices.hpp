// Real synthesised speech for tests, by flite. Its samples differ a little from
// run to run (it excites by noise); its length does not.
#pragma once

#include <string>

#include "tests/support/audio/sounds.hpp"

namespace parlour::test {

// Whether the tests were built with flite.
bool can_speak();

// `voice` is rms, slt, awb or kal16. Empty without flite. One thread at a time.
Sound spoken(const std::string& text, const std::string& voice = "rms");

// Several voices at once, of sentences that belong to no application.
Sound babble(std::uint64_t seed, std::int64_t milliseconds, double level);

} // namespace parlour::test
