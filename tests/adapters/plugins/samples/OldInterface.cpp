// A plug-in built for another version of the plug-in interface. Only the
// version number may be read.
#include <cstdint>

extern "C" const std::uint32_t parlour_plugin[];
const std::uint32_t parlour_plugin[] = {0, 0xffffffff};
