#include "engines/engine.hpp"

#include "oracle/parry/ledger/rows.hpp"

namespace manifuzz {

Engine engine_parry() {
  using namespace parry;
  static const auto as_they_are = rows_but_for({"kept-normals"}, kRowsOfManifolds<Floats>);
  static const auto simplified = rows_but_for({"squared-length"}, kRowsOfManifolds<Floats>);
  static const auto in_doubles =
      rows_but_for({"squared-length", "kept-normals", "not-a-number"}, kRowsOfManifolds<Doubles>);
  return {.name = "parry",
          .ledger = {{"parry2d", as_they_are},
                     {"parry2d-f64", in_doubles},
                     {"parry2d-simplified", simplified}}};
}

}  // namespace manifuzz
