/// \file
/// What a style sheet cannot say about the Fusion style.
#pragma once

#include <QProxyStyle>

namespace ramure {

class RamureStyle : public QProxyStyle
{
    Q_OBJECT
public:
    RamureStyle();

    /// Nothing is changed by a wheel that passes by (widgets/base/theme/wheel_guard.h); buttons have a name
    /// and a place in the order of Tab; areas that scroll have none, what they show has.
    using QProxyStyle::polish;
    void polish(QWidget* widget) override;
    /// Disabled icons are the same, only fainter: Fusion's own way makes light icons lighter.
    QPixmap generatedIconPixmap(QIcon::Mode mode, const QPixmap& pixmap,
                                const QStyleOption* option) const override;
    /// No icons on the buttons of dialogs: those of the base style are not drawn for a dark theme.
    int styleHint(StyleHint hint, const QStyleOption* option = nullptr, const QWidget* widget = nullptr,
                  QStyleHintReturn* data = nullptr) const override;
};

} // namespace ramure
