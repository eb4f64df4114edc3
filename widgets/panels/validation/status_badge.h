/// \file
/// A round sign that says at a glance how a check ended. Drawn, so it is crisp at every scale and in both
/// themes.
#pragma once

#include <QWidget>

namespace ramure {

class StatusBadge : public QWidget
{
    Q_OBJECT
public:
    enum class Status { Unknown, Good, Warning, Bad };

    explicit StatusBadge(QWidget* parent = nullptr);

    void setStatus(Status status);
    [[nodiscard]] Status status() const { return m_status; }
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Status m_status = Status::Unknown;
};

} // namespace ramure
