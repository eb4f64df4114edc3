/// \file
/// The hint of a widget that always says the same.
#pragma once

#include "widgets/base/hint_source.h"
#include <QWidget>
#include <functional>

namespace ramure {

class FixedHint : public HintSource
{
    Q_OBJECT
public:
    /// \param widget owns the hint. \param text in the present language; asked again when it changes
    FixedHint(QWidget* widget, std::function<QString()> text);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::function<QString()> m_text;
};

} // namespace ramure
