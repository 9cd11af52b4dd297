#include "report/sequence/sequence_report.hpp"

namespace manifuzz {
std::string filmstrip_svg(const JudgedSequence&) {
  return "";
}
}  // namespace manifuzz
