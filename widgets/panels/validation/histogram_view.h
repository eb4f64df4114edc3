/// \file
/// A small bar chart of counts: how the triangles of a mesh are spread over their smallest angles.
#pragma once

#include <QWidget>
#include <vector>

namespace ramure {

class HistogramView : public QWidget
{
    Q_OBJECT
public:
    explicit HistogramView(QWidget* parent = nullptr);

    /// \param warnBelow so many bars from the left are drawn in the colour of warnings.
    void setCounts(std::vector<quint64> counts, int warnBelow);
    [[nodiscard]] const std::vector<quint64>& counts() const { return m_counts; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<quint64> m_counts;
    int m_warnBelow = 0;
};

} // namespace ramure
