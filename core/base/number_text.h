/// \file
/// Numbers as text: shortest form that reads back as the same number, C locale always.
#pragma once

#include <charconv>
#include <string>

namespace ramure {

template <class T> std::string numberText(T number)
{
    char buffer[64];
    const char* end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
    return {static_cast<const char*>(buffer), end};
}

} // namespace ramure
