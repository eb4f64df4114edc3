/// \file
/// A button that is a picture with a name below it.
#pragma once

#include <QAbstractButton>
#include <QPixmap>

namespace ramure {

class PictureButton : public QAbstractButton
{
    Q_OBJECT
public:
    /// \param picture path of an image, twice as large as it is shown.
    explicit PictureButton(const QString& picture, QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QPixmap m_picture;
};

} // namespace ramure
