// Sentences of a reception desk, as an application would have them: with the
// staff, places and companies that it knows (desk/train.jsonl and
// desk/gazetteer.json in the folder).
#pragma once

#include "tools/bench/nlu/nlu_data.hpp"

namespace parlour::tools {

// Sentences made of one template ("call me a cab to …") are learnt or measured
// together: one in four templates is held back, in four turns. Both parts are
// the same, so settings may be chosen by them, and they are no test.
Expected<NluSets> read_desk(const std::filesystem::path& folder, DataPart part);

} // namespace parlour::tools
