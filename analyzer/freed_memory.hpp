#pragma once

namespace recoat {

/// Memory that is freed stays with the program for what it needs next, for as long as it runs. Otherwise every large
/// array goes back to the system and comes anew, in pages that are cleared when first touched: for a million particles
/// a tenth of the time. To be called before other threads begin.
void keep_freed_memory() noexcept;

}  // namespace recoat
