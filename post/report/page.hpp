// The page of a study from its components: texts, tables and pictures.
#pragma once

#include <string>
#include <vector>

namespace graincrack {

/// A page in Markdown, its components in the order of the files: texts (.md) as they are; tables (.tsv) under their names,
/// numbers with four digits; pictures (.png, .svg) by links to files of the same folder as the page. \throws UsageError for a
/// file of another kind, InputError for one that cannot be read, or a table that has a column twice
std::string markdown_page(const std::vector<std::string>& files);

/// The same page in HTML, with the style of a report. Its title is the first heading.
std::string html_page(const std::string& markdown);

}  // namespace graincrack
