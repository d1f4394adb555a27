use merev::math::*; use merev::*;
fn main() {
    let mut w = World::try_new(&WorldDef{enable_sleep:false,restitution_threshold:0.0,gravity:vec3(0.0,-9.81,0.0),..Default::default()}).unwrap(); 
    let mut d = ShapeDef::default(); d.material.restitution=0.8;
    w.create_body_with_shape(&BodyDef::fixed(vec3(0.0,-0.5,0.0)), &d, Shape::new_box(20.0,1.0,20.0)).unwrap();
    let h0: Float = std::env::args().nth(1).unwrap().parse().unwrap();
    let b = w.create_body_with_shape(&BodyDef::dynamic(vec3(0.0,0.1+h0,0.0)), &d, Shape::new_sphere(0.2)).unwrap().0;
    for i in 0..200 { w.try_step(1.0/60.0,4).unwrap(); let bb=w.body(b).unwrap(); println!("{i} y {} v {} c {}", bb.transform().p.y-0.1, bb.linear_velocity().y, w.counters().constraints); }
}
