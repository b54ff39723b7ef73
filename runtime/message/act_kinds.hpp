// ActKind: what a user does with an utterance, from acts.def. Pure; safe from
// any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parlour {

enum class ActKind : std::uint8_t {
#define ACT(name, sentence) name,
#include "runtime/message/acts.def"
#undef ACT
};

inline constexpr auto last_act_kind = static_cast<ActKind>(-1
// NOLINTNEXTLINE(bugprone-macro-parentheses): it adds up the acts
#define ACT(name, sentence) +1
#include "runtime/message/acts.def"
#undef ACT
);

std::string_view name_of(ActKind kind);
// Nothing if there is no act of that name.
std::optional<ActKind> act_kind(std::string_view name);
// In the order of the table.
const std::vector<std::string>& act_names();

} // namespace parlour
