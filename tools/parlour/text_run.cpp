#include "tools/parlour/text_run.hpp"

namespace parlour::tools {

bool talk_by_rows(Partner& partner, RowReader& rows) {
  for (;;) {
    const auto event = rows.next();
    switch (event.kind) {
    case RowEvent::Kind::turns:
      partner.enter(event.turns);
      // In real time the world goes on by itself while we read.
      if (partner.is_virtual() || event.is_part)
        partner.run_until_quiet();
      break;
    case RowEvent::Kind::quiet:
      partner.run_until_quiet();
      break;
    case RowEvent::Kind::step:
      partner.step_to_next_due();
      break;
    case RowEvent::Kind::end:
      partner.run_until_quiet();
      return true;
    case RowEvent::Kind::interrupted:
      return false;
    }
  }
}

} // namespace parlour::tools
