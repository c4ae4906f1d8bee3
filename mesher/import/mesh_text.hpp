// The text of a mesh file, read word by word or line by line.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace graincrack::mesher {

/// A place in the text of a file. Whatever is not there or not as expected is an InputError naming the file, the line and what
/// was found; no number of a file is trusted to be the size of anything before so many bytes were seen to be there.
class MeshText {
public:
    /// \param name of the file, for messages
    MeshText(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

    [[nodiscard]] bool at_end();  ///< whether only white space follows
    /// The rest of the line, without white space at its ends; "" at the end of the file.
    std::string_view line();
    std::string_view word(const char* what);
    std::int64_t integer(const char* what);  ///< a word that is one
    double number(const char* what);         ///< a word that is a finite number
    /// A number of things that follow, each of some bytes at least.
    std::size_t count(const char* what, std::size_t bytes_each = 1);
    /// A text between double quotes.
    std::string quoted(const char* what);
    /// Passes over lines up to one that is `text`. \return false if there is none
    bool skip_to(std::string_view text);

    [[noreturn]] void fail(const std::string& message) const;
    [[nodiscard]] const std::string& name() const { return name_; }

private:
    void skip_white_space();

    std::string_view bytes_;
    std::string name_;
    std::size_t place_ = 0;
    std::size_t line_ = 1;
};

}  // namespace graincrack::mesher
