/// \file
/// A value that is made when somebody first asks for it, on the thread of whoever asks.
#pragma once

#include <functional>
#include <mutex>
#include <optional>

namespace ramure {

template <class T> class Lazy
{
public:
    explicit Lazy(std::function<T()> make)
        : m_make(std::move(make))
    {
    }
    /// Any number of threads may ask; the others wait for the first.
    const T& operator*() const
    {
        std::call_once(m_once, [this] {
            m_value.emplace(m_make());
            m_make = nullptr;
        });
        return *m_value;
    }
    const T* operator->() const { return &**this; }

private:
    mutable std::once_flag m_once;
    mutable std::function<T()> m_make;
    mutable std::optional<T> m_value;
};

} // namespace ramure
