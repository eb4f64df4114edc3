/// \file
/// One setting of several that an object with a signal changed() holds.
#pragma once

#include <QObject>
#include <utility>

namespace ramure {

/// \tparam Owner holds the option and tells of changes by its signal changed().
template <class Owner, class T> class Option
{
public:
    Option(Owner* owner, T value)
        : m_owner(owner)
        , m_value(std::move(value))
    {
    }
    [[nodiscard]] const T& operator()() const { return m_value; }
    void set(const T& value)
    {
        if (m_value == value)
            return;
        m_value = value;
        emit m_owner->changed();
    }
    /// Calls \p call after each change of this option, while \p context lives.
    template <class Call> void follow(QObject* context, Call call) const
    {
        QObject::connect(m_owner, &Owner::changed, context, [this, call, before = m_value]() mutable {
            if (std::exchange(before, m_value) != m_value)
                call();
        });
    }

private:
    Owner* m_owner;
    T m_value;
};

} // namespace ramure
