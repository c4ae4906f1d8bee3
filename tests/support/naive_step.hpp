// The explicit time step in its simplest form, a reference for the fast one: node by node, element by element, contact point by
// contact point, directly from the equations. It shares only the pure functions of the contact laws and platens with the solver.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "solver/law/contact_law.hpp"
#include "solver/law/damping.hpp"
#include "solver/model/boundary.hpp"

namespace graincrack::test {

/// A specimen between platens, without membrane, node–edge contacts and mass scaling. Nodes in the order of the assemblage.
class NaiveRun {
public:
    using Vector = Eigen::Vector2d;

    /// \param laws by place of the contact
    NaiveRun(const Assemblage& assemblage, const Boundary& boundary, const std::vector<ContactLaw>& laws, double time_step,
             double damping, DampingForm form)
        : a_(assemblage),
          boundary_(boundary),
          laws_(laws),
          time_step_(time_step),
          damping_(damping),
          form_(form),
          displacement_(assemblage.position.size(), Vector::Zero()),
          velocity_(displacement_),
          force_(displacement_),
          last_force_(displacement_),
          history_(2 * assemblage.contacts.size()),
          platen_points_(boundary.platen_points) {}

    void set_velocity(std::size_t node, const Vector2& v) { velocity_[node] = {v.x, v.y}; }
    /// A step with the platens at these displacements.
    void step(const std::array<double, 2>& platen_displacement) {
        std::fill(force_.begin(), force_.end(), Vector::Zero());
        add_elements();
        add_contacts();
        add_platens(platen_displacement);
        for (std::size_t i = 0; i < force_.size(); ++i) {
            Vector force = force_[i];
            for (int k = 0; k < 2; ++k) {
                const double v = velocity_[i][k];
                const double change = force_[i][k] - last_force_[i][k];
                const double size = damping_ * std::abs(force_[i][k]);
                if (form_ == DampingForm::local) {
                    force[k] -= v == 0 ? 0.0 : std::copysign(size, v);
                } else {
                    force[k] -= v == 0 ? 0.0 : std::copysign(size / 2, v);
                    force[k] += change == 0 ? 0.0 : std::copysign(size / 2, change);
                }
            }
            velocity_[i] += time_step_ / a_.mass[i] * force;
            displacement_[i] += time_step_ * velocity_[i];
        }
        last_force_ = force_;
    }
    [[nodiscard]] const std::vector<Vector>& displacement() const { return displacement_; }
    [[nodiscard]] const std::vector<Vector>& velocity() const { return velocity_; }
    [[nodiscard]] std::size_t failed_points() const {
        return static_cast<std::size_t>(
            std::count_if(history_.begin(), history_.end(), [](const ContactHistory& h) { return h.failed(); }));
    }

private:
    [[nodiscard]] Vector reference(std::int32_t node) const { return {a_.position[node].x, a_.position[node].y}; }

    /// P = R T, T = λ tr(U − I) 1 + 2μ (U − I), F = R U; force −A P ∇N.
    void add_elements() {
        for (std::size_t e = 0; e < a_.element_nodes.size(); ++e) {
            const auto& nodes = a_.element_nodes[e];
            const PlaneElasticity elasticity = a_.elasticity[e];
            Eigen::Matrix2d reference_edges;
            Eigen::Matrix2d edges;
            for (int k = 0; k < 2; ++k) {
                reference_edges.col(k) = reference(nodes[static_cast<std::size_t>(k) + 1]) - reference(nodes[0]);
                edges.col(k) =
                    reference_edges.col(k) + displacement_[nodes[static_cast<std::size_t>(k) + 1]] - displacement_[nodes[0]];
            }
            const Eigen::Matrix2d gradients = reference_edges.inverse();  // rows: of N1, N2
            const Eigen::Matrix2d deformation = edges * gradients;
            const Eigen::Rotation2Dd rotation(
                std::atan2(deformation(1, 0) - deformation(0, 1), deformation(0, 0) + deformation(1, 1)));
            const Eigen::Matrix2d r = rotation.toRotationMatrix();
            const Eigen::Matrix2d strain = r.transpose() * deformation - Eigen::Matrix2d::Identity();
            const Eigen::Matrix2d stress =
                elasticity.c12 * strain.trace() * Eigen::Matrix2d::Identity() + elasticity.mu * (strain + strain.transpose());
            const Eigen::Matrix2d forces = -0.5 * reference_edges.determinant() * r * stress * gradients.transpose();
            force_[nodes[1]] += forces.col(0);
            force_[nodes[2]] += forces.col(1);
            force_[nodes[0]] -= forces.col(0) + forces.col(1);
        }
    }

    /// Tractions at both points, and the couple that balances the moment of the tractions about the rotating mean edge.
    void add_contacts() {
        for (std::size_t c = 0; c < a_.contacts.size(); ++c) {
            if (a_.specimen_contact[c] < 0) continue;
            const auto [a1, a2, b1, b2] = a_.contacts[c].nodes;
            const double area = 0.5 * (reference(a2) - reference(a1)).norm();
            const Vector middle = 0.5 * (reference(a2) + displacement_[a2] - reference(a1) - displacement_[a1] + reference(b2) +
                                         displacement_[b2] - reference(b1) - displacement_[b1]);
            const Vector tangent = middle.normalized();
            const Vector normal(tangent.y(), -tangent.x());
            const std::array<std::array<std::int32_t, 2>, 2> pairs{{{a1, b1}, {a2, b2}}};
            double couple = 0;
            for (std::size_t p = 0; p < 2; ++p) {
                const Vector jump = displacement_[pairs[p][1]] - displacement_[pairs[p][0]];
                const ContactMotion motion{jump.dot(normal), jump.dot(tangent)};
                const ContactResponse response = update_contact(laws_[c], motion, history_[2 * c + p]);
                history_[2 * c + p] = response.history;
                const Vector pull = area * (response.traction.normal * normal + response.traction.shear * tangent);
                force_[pairs[p][0]] += pull;
                force_[pairs[p][1]] -= pull;
                couple += area * (response.traction.normal * motion.sliding - response.traction.shear * motion.opening);
            }
            const Vector turn = couple / (2 * middle.norm()) * normal;
            force_[a1] -= turn;
            force_[b1] -= turn;
            force_[a2] += turn;
            force_[b2] += turn;
        }
    }

    void add_platens(const std::array<double, 2>& platen_displacement) {
        for (PlatenPoint& point : platen_points_) {
            const Vector u = displacement_[point.node];
            const PlatenResponse r = platen_response(boundary_.platens[point.platen], point, {u.x(), u.y()},
                                                     platen_displacement[static_cast<std::size_t>(point.platen)]);
            force_[point.node] += Vector(r.force.x, r.force.y);
            point.anchor = r.anchor;
            point.shear = r.shear;
        }
    }

    const Assemblage& a_;
    const Boundary& boundary_;
    std::vector<ContactLaw> laws_;
    double time_step_;
    double damping_;
    DampingForm form_;
    std::vector<Vector> displacement_;
    std::vector<Vector> velocity_;
    std::vector<Vector> force_;
    std::vector<Vector> last_force_;
    std::vector<ContactHistory> history_;
    std::vector<PlatenPoint> platen_points_;
};

}  // namespace graincrack::test
