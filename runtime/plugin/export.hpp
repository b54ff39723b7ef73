// The macro that turns a shared library into a plug-in. Write one line below
// the class; the file must have the plug-in's name (here EchoTTS.so):
//
//   PARLOUR_PLUGIN(EchoTTS, {.name = "EchoTTS",
//                            .roles = {"TTS"},
//                            .sentence = "says what it is to say"})
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "runtime/plugin/plugin.hpp"

namespace parlour {

// Raised with each change that breaks plug-ins built before it.
inline constexpr std::uint32_t plugin_interface = 3;

// Sizes of the types that cross the border between the program and a plug-in.
// Both are C++, so they must be built with compatible compilers, libraries and
// settings; if one of these sizes differs, they are not.
struct PluginAbi {
  std::uint32_t pointer = sizeof(void*);
  std::uint32_t string = sizeof(std::string);
  std::uint32_t value = sizeof(Value);
  std::uint32_t message = sizeof(Message);
  std::uint32_t description = sizeof(PluginDescription);
  std::uint32_t plugin = sizeof(IPlugin);

  bool operator==(const PluginAbi&) const = default;
};

// The type of the exported symbol `parlour_plugin`. `interface` stays the first
// member in every version; the loader reads nothing else if it differs.
struct PluginLibrary {
  std::uint32_t interface = plugin_interface;
  PluginAbi abi;
  PluginFactory (*factory)() = nullptr;
};

inline constexpr const char* plugin_symbol = "parlour_plugin";

} // namespace parlour

#define PARLOUR_PLUGIN(Class, ...)                                             \
  extern "C" {                                                                 \
  extern const ::parlour::PluginLibrary parlour_plugin;                        \
  const ::parlour::PluginLibrary parlour_plugin{                               \
      ::parlour::plugin_interface, ::parlour::PluginAbi{}, [] {                \
        return ::parlour::PluginFactory{                                       \
            __VA_ARGS__, [] { return std::make_unique<Class>(); }};            \
      }};                                                                      \
  }
