// in_parallel: does many things that share nothing that changes, several at a
// time.
#pragma once

#include <cstddef>
#include <functional>

namespace parlour::tools {

// Calls `work` with each index below `count`, on so many threads, of which the
// caller's is one; 0: as many as the machine has processors. Returns when all
// of it is done.
void in_parallel(std::size_t count, unsigned threads,
                 const std::function<void(std::size_t)>& work);

} // namespace parlour::tools
