#include "adapters/standins/log_taxi.hpp"

#include "runtime/base/random.hpp"

namespace parlour::adapters {

namespace {

// Makes an unrelated number of each number, so that successive bookings do not
// look alike.
std::uint64_t scattered(std::uint64_t number) {
  return Random(number).next();
}

} // namespace

// The sum of the last two letters of the prefix (A is 1) and the four digits,
// weighted by 9, 4, 5, 4, 3, 2, modulo 19.
char singapore_check_letter(std::string_view prefix, std::uint64_t digits) {
  constexpr std::string_view letters = "AZYXUTSRPMLKJHGEDCB";
  auto place = [](char c) { return static_cast<std::uint64_t>(c - 'A' + 1); };
  const auto sum = place(prefix[1]) * 9 + place(prefix[2]) * 4 +
                   digits / 1000 * 5 + digits / 100 % 10 * 4 +
                   digits / 10 % 10 * 3 + digits % 10 * 2;
  return letters[sum % letters.size()];
}

std::string singapore_taxi_plate(std::uint64_t number) {
  constexpr std::string_view series = "ABCDX";
  // Different bits choose the series and the digits, 1 to 9999.
  const auto chosen = scattered(number);
  const std::string prefix = {'S', 'H', series[chosen % series.size()]};
  const auto digits = 1 + chosen / 8 % 9999;
  return prefix + ' ' + std::to_string(digits) + ' ' +
         singapore_check_letter(prefix, digits);
}

Expected<void> LogTaxi::on_options(const Options& options) {
  auto answer = option_of(options, "answer", {"booked", "refused"});
  if (!answer)
    return tl::make_unexpected(answer.error());
  const auto seed = parse_number(option_or(options, "seed", "1"));
  if (!seed.if_integer())
    return fail(ErrorKind::settings, "option 'seed' is a whole number");
  refuses_ = *answer == "refused";
  seed_ = static_cast<std::uint64_t>(*seed.if_integer());
  return {};
}

bool LogTaxi::carry_out(const Message& message) {
  if (message.command != "Book")
    return false;
  const auto number = scattered(seed_) + bookings_;
  if (refuses_)
    fire_event("Refused", {"No taxi is free."});
  else if (text_param(message, 0).empty() || text_param(message, 1).empty())
    fire_event("Refused", {"A taxi needs to know from where and to where."});
  else {
    // 4 to 12 minutes.
    const auto minutes = static_cast<int>(4 + scattered(~number) % 9);
    fire_event("Booked", {singapore_taxi_plate(number), minutes});
    ++bookings_;
  }
  return true;
}

PluginFactory log_taxi_factory() {
  auto description = describe_stand_in(
      "LogTaxi", "Taxi", "the taxi company",
      {{"answer",
        "booked",
        "how bookings end",
        false,
        OptionType::choice,
        {"booked", "refused"}},
       {"seed", "1", "which plates and waiting times it makes up", false,
        OptionType::integer}});
  return {description, [] { return std::make_unique<LogTaxi>(); }};
}

} // namespace parlour::adapters
