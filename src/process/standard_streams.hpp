#pragma once

namespace manifuzz {

/// Fills in the standard streams that are closed, so that no pipe takes their places. Reading from
/// or writing to one of these fails as before.
void fill_in_standard_streams();

}  // namespace manifuzz
