/// \file
/// The variations of a tree that stand in a grid: their pictures as they come, and which are starred.
#pragma once

#include "core/qt/session/jobs/variations.h"
#include <QAbstractListModel>
#include <QPixmap>

namespace ramure {

class VariationsModel : public QAbstractListModel
{
    Q_OBJECT
public:
    enum Role { StarRole = Qt::UserRole, ProblemRole };
    enum class Choice { All, Starred, Rest };

    using QAbstractListModel::QAbstractListModel;

    void clear();
    /// Those with a star stay, at the front; the others make room for these.
    void offer(const std::vector<Variation>& variations);
    [[nodiscard]] const Variation& at(int row) const { return m_items[std::size_t(row)].variation; }
    [[nodiscard]] std::vector<Variation> chosen(Choice choice) const;
    [[nodiscard]] bool isStarred(int row) const { return m_items[std::size_t(row)].starred; }
    void setStarred(int row, bool starred);
    /// The first row without a picture and without a problem, or the one of the oldest tree; -1: there is
    /// none.
    [[nodiscard]] int nextUndrawn(bool oldest = false) const;
    [[nodiscard]] int drawn() const; ///< with a picture or a problem
    void setPicture(int row, const QPixmap& picture);
    /// \param problem in the interface's language
    void setProblem(int row, const QString& problem);
    void setAngleUnit(bool degrees) { m_degrees = degrees; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

private:
    struct Item
    {
        Variation variation;
        QPixmap picture;
        QString problem;
        bool starred = false;
    };
    [[nodiscard]] QString tipOf(const Item& item) const;

    std::vector<Item> m_items;
    bool m_degrees = true;
};

} // namespace ramure
