#include "tools/parlour/understand/reader.hpp"

#include <cmath>
#include <utility>

#include "runtime/text/json_text.hpp"
#include "tools/parlour/application/sql/column_reader.hpp"
#include "tools/parlour/application/understanding.hpp"

namespace parlour::tools {

Reader::Reader(std::unique_ptr<OwnWords> own, adapters::nlu::NluEngine engine)
    : own_(std::move(own)), engine_(std::move(engine)) {}

tl::expected<Reader, std::vector<Error>>
Reader::open(const Application& application, const ChosenComponent& component,
             Timestamp clock) {
  // Columns come from a copy of the database in memory, so no run's data
  // matter.
  auto engine = build_engine(application, component,
                             column_reader(rehearsed(application.composition),
                                           application.folder, ""));
  if (!engine)
    return tl::make_unexpected(std::move(engine.error()));
  auto own = OwnWords::start(application, clock);
  if (!own)
    return tl::make_unexpected(std::vector{own.error()});
  return Reader(std::move(*own), std::move(*engine));
}

Reading Reader::read(const std::string& text, const Map& context,
                     bool explain) {
  Reading reading{own_->say(text), {}};
  if (!reading.sent)
    return reading;
  for (const auto& [key, value] : context.entries())
    reading.sent->context.set(key, value);
  reading.made =
      engine_.understand(reading.sent->text, reading.sent->context, explain);
  return reading;
}

std::string reading_line(const std::string& text, const Reading& reading) {
  Map line{{"text", text},
           {"sent", reading.sent ? Value(reading.sent->text) : Value()}};
  line.set("acts", reading.made.acts);
  line.set("score", std::round(reading.made.score * 1000) / 1000);
  return json_text(std::move(line));
}

} // namespace parlour::tools
