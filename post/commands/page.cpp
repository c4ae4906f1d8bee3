#include "post/commands/page.hpp"

#include "post/report/page.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

Command page_command() {
    enum class Form { markdown, html };
    return make_command<Form>(
        "page", "one page from texts, tables and pictures, in the order of the files",
        {"properties.tsv modes.tsv", "properties.tsv cracks.png --format html"},
        FileArguments{"files", "texts (.md), tables (.tsv) and pictures (.png, .svg)"},
        [](OptionSet set, Form& form) {
            add_choice<Form>(set, "--format", form, {{"markdown", Form::markdown}, {"html", Form::html}},
                             "form of the page; pictures are links to files in its folder");
        },
        [](const Form& form, const Call& call) {
            const std::string markdown = markdown_page(call.files);
            call.out << (form == Form::html ? html_page(markdown) : markdown);
        });
}

}  // namespace graincrack
