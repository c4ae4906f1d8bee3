// The bytes of a mesh file, read word by word, line by line or as binary numbers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace graincrack::mesher {

/// A place in the bytes of a file. Whatever is not there or not as expected is an InputError naming the file, the line (in
/// binary parts the byte) and what was found; no number of a file is trusted to be the size of anything before so many bytes
/// were seen to be there.
class MeshText {
public:
    /// \param name of the file, for messages
    MeshText(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

    [[nodiscard]] bool at_end();  ///< whether only white space follows
    [[nodiscard]] std::size_t bytes_left() const { return bytes_.size() - place_; }
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

    void begin_binary() { is_binary_ = true; }  ///< right after the end of a line
    void end_binary() { is_binary_ = false; }
    /// Numbers that are binary or text, as the place is in.
    std::int64_t int32(const char* what);
    std::int64_t size(const char* what);  ///< of 8 bytes, 0 to 2^62
    double real(const char* what);
    std::size_t size_count(const char* what, std::size_t bytes_each = 1);

    [[noreturn]] void fail(const std::string& message) const;
    [[nodiscard]] const std::string& name() const { return name_; }

private:
    template <typename T>
    T binary(const char* what);
    void skip_white_space();
    std::size_t plausible(std::int64_t value, const char* what, std::size_t bytes_each) const;

    std::string_view bytes_;
    std::string name_;
    std::size_t place_ = 0;
    std::size_t line_ = 1;
    bool is_binary_ = false;
};

}  // namespace graincrack::mesher
