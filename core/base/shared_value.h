/// \file
/// Large data that is shared and never changed in place. Two values are equal if their contents are.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

namespace ramure {

/// T has a function hashOf(const T&), found beside it. The hash is computed once, when the value is made, on
/// the thread that makes it.
template <class T> class SharedValue
{
public:
    SharedValue() = default;
    explicit SharedValue(T value)
        : m_held(std::make_shared<const Held>(std::move(value)))
    {
    }
    [[nodiscard]] explicit operator bool() const { return m_held != nullptr; }
    const T& operator*() const { return m_held->value; }
    const T* operator->() const { return m_held ? &m_held->value : nullptr; }
    [[nodiscard]] std::shared_ptr<const T> pointer() const { return {m_held, operator->()}; }
    /// hashOf() the value; 0 where there is none.
    [[nodiscard]] std::uint64_t hash() const { return m_held ? m_held->hash : 0; }
    bool operator==(const SharedValue& other) const
    {
        return m_held == other.m_held || (m_held && other.m_held && m_held->hash == other.m_held->hash &&
                                          m_held->value == other.m_held->value);
    }

private:
    struct Held
    {
        explicit Held(T&& made)
            : value(std::move(made))
            , hash(hashOf(value))
        {
        }
        T value;
        std::uint64_t hash;
    };

    std::shared_ptr<const Held> m_held;
};

} // namespace ramure
