// A rectangle of 20 × 40 mm of two minerals, with a joint between them: the source of the meshes beside it, by Gmsh 4.8.4:
//
//     gmsh two-minerals.geo -2 -format msh22 -o two-minerals-msh22.msh
//     gmsh two-minerals.geo -2 -format msh41 -order 2 -o two-minerals-msh41.msh
//
// Of the second, elements were then given their corners alone.
h = 10;
Point(1) = {0, 0, 0, h};
Point(2) = {20, 0, 0, h};
Point(3) = {20, 25, 0, h};
Point(4) = {20, 40, 0, h};
Point(5) = {0, 40, 0, h};
Point(6) = {0, 15, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {6, 3};
Curve Loop(1) = {1, 2, -7, 6};
Curve Loop(2) = {7, 3, 4, 5};
Plane Surface(3) = {1};
Plane Surface(8) = {2};
Physical Surface("Quartz") = {3};
Physical Surface("Feldspar") = {8};
Physical Curve("bottom") = {1};
Physical Curve("top") = {4};
Physical Curve("flaw-joint") = {7};
