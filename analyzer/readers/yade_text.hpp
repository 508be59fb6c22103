#pragma once

#include "analyzer/readers/reader.hpp"

namespace recoat {

/// Whether the file is a text export of Yade: comments on top, one of them "#format x_y_z_r...".
bool is_yade_text(const Content& content);

/// Reads what yade.export.text and textExt write; columns after the radius are passed over.
Series open_yade_text(const Content& content, const ReadOptions& options);

inline constexpr Reader yade_text_reader = {"yade-text", "text exports of Yade (export.text, export.textExt)",
                                            is_yade_text, open_yade_text};

}  // namespace recoat
