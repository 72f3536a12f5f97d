//! A ray's way through the trees.

use super::Named;
use crate::Explanation;
use serde::Serialize;

#[derive(Serialize)]
pub(super) struct Way<'a> {
    box_count: usize,
    test_count: usize,
    boxes: Vec<Visit<'a>>,
    tests: Vec<Test<'a>>,
}

#[derive(Serialize)]
struct Visit<'a> {
    level: u32,
    object: Option<Named<'a>>,
    leaf: bool,
    corners: [[f32; 3]; 8],
}

#[derive(Serialize)]
struct Test<'a> {
    object: Named<'a>,
    primitive: u32,
    in_box: Option<u32>,
    t: Option<f32>,
}

impl<'a> Way<'a> {
    pub(super) fn of(explanation: &Explanation<'a>, ray: u32) -> Self {
        let walk = explanation.account.walk(explanation.compiled, ray);
        let boxes = walk.boxes.iter().map(|visit| Visit {
            level: visit.level,
            object: visit.object.map(|object| explanation.object(object)),
            leaf: visit.leaf,
            corners: visit.corners.map(|corner| corner.to_array()),
        });
        let tests = walk.tests.iter().map(|test| Test {
            object: explanation.object(test.object),
            primitive: test.primitive,
            in_box: test.in_box,
            t: test.t,
        });
        Self {
            box_count: walk.boxes.len(),
            test_count: walk.tests.len(),
            boxes: boxes.collect(),
            tests: tests.collect(),
        }
    }
}
