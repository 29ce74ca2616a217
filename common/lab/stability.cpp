#include <Eigen/Eigenvalues>
#include <nutshell/lab/stability.hpp>

namespace nutshell::lab {

double spectral_radius(const Eigen::MatrixXd& matrix) {
    require(matrix.rows() == matrix.cols() && matrix.rows() > 0,
            "spectral_radius: the matrix must be square and not empty");
    require(matrix.allFinite(), "spectral_radius: the matrix holds a number that is not finite");
    return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace nutshell::lab
