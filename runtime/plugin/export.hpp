// What makes a shared library a plug-in: one line behind the class.
//
//   PARLOUR_PLUGIN(EchoTTS, {.name = "EchoTTS",
//                            .roles = {"TTS"},
//                            .sentence = "says what it is to say"})
//
// The file is called as the plug-in: EchoTTS.so.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "runtime/plugin/plugin.hpp"

namespace parlour {

// Raised with each change that a plug-in built before would not survive.
inline constexpr std::uint32_t plugin_interface = 2;

// By what program and plug-in know that they mean the same by the same types:
// compilers, libraries and settings that differ in one of these cannot talk.
struct PluginAbi {
  std::uint32_t pointer = sizeof(void*);
  std::uint32_t string = sizeof(std::string);
  std::uint32_t value = sizeof(Value);
  std::uint32_t message = sizeof(Message);
  std::uint32_t description = sizeof(PluginDescription);
  std::uint32_t plugin = sizeof(IPlugin);

  bool operator==(const PluginAbi&) const = default;
};

// What the symbol `parlour_plugin` is. The interface stands first in every
// version, and nothing behind it is looked at where it is another.
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
