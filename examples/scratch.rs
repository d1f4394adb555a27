use merev::math::*;
use merev::*;
use merev::world::*;
fn ground(w: &mut World, mu: Float) { 
    let mut d = ShapeDef::default(); d.material.friction = mu;
    w.create_body_with_shape(&BodyDef::fixed(vec3(0.0,-0.5,0.0)), &d, Shape::new_box(200.0,1.0,200.0)).unwrap(); }
fn sub() -> u32 { std::env::var("SUB").ok().and_then(|s| s.parse().ok()).unwrap_or(4) }
fn main() {
    let which: Vec<String> = std::env::args().skip(1).collect();
    let on = |s: &str| which.is_empty() || which.iter().any(|w| w == s);
    let h = 1.0/60.0;
    if on("fall") {
        let mut w = World::try_new(&WorldDef::default()).unwrap();
        let b = w.create_body_with_shape(&BodyDef::dynamic(vec3(0.0,10.0,0.0)), &ShapeDef::default(), Shape::new_box(1.0,1.0,1.0)).unwrap().0;
        for _ in 0..60 { w.try_step(h,sub()).unwrap(); }
        println!("fall y {}", w.body(b).unwrap().transform().p.y - 5.0);
    }
    if on("rest") {
        let mut w = World::try_new(&WorldDef{enable_sleep:false,enable_load_memory: std::env::var("MEM").is_err(), contact_stiffness: std::env::var("ST").ok().and_then(|s| s.parse().ok()).unwrap_or(0.21), contact_damping_ratio: std::env::var("ZE").ok().and_then(|s| s.parse().ok()).unwrap_or(0.5),..Default::default()}).unwrap(); ground(&mut w, 0.6);
        let b = w.create_body_with_shape(&BodyDef::dynamic(vec3(0.0,0.5,0.0)), &ShapeDef::default(), Shape::new_box(1.0,1.0,1.0)).unwrap().0;
        for i in 0..600 { w.try_step(h,sub()).unwrap(); if i%60==59 { println!("rest y {:e} v {:e}", w.body(b).unwrap().transform().p.y - 0.5, w.body(b).unwrap().linear_velocity().y); } }
    }
    for n in [10,20] { if on("stack") {
        let mut w = World::try_new(&WorldDef{enable_sleep:false,enable_load_memory: std::env::var("MEM").is_err(), contact_stiffness: std::env::var("ST").ok().and_then(|s| s.parse().ok()).unwrap_or(0.21), contact_damping_ratio: std::env::var("ZE").ok().and_then(|s| s.parse().ok()).unwrap_or(0.5),..Default::default()}).unwrap(); ground(&mut w, 0.6);
        let ids: Vec<_> = (0..n).map(|i| w.create_body_with_shape(&BodyDef::dynamic(vec3(0.0,0.5+i as Float,0.0)), &ShapeDef::default(), Shape::new_box(1.0,1.0,1.0)).unwrap().0).collect();
        for i in 0..1200 { w.try_step(h,sub()).unwrap(); if i%120==119 { let r = w.step_report(); let t = w.body(ids[n-1]).unwrap().transform().p; println!("stack {n} t {} pen {:.5} mm top {:.5} drift {:e} ke {:e}", (i+1)/60, r.worst_penetration*1e3, t.y-(n as Float-0.5), (t.x*t.x+t.z*t.z).sqrt(), r.kinetic_energy); } }
    }}
    if on("feat") { let n=20;
        let mut w = World::try_new(&WorldDef{enable_sleep:false,enable_load_memory: std::env::var("MEM").is_err(), contact_stiffness: std::env::var("ST").ok().and_then(|s| s.parse().ok()).unwrap_or(0.21), contact_damping_ratio: std::env::var("ZE").ok().and_then(|s| s.parse().ok()).unwrap_or(0.5),..Default::default()}).unwrap(); ground(&mut w, 0.6);
        let ids: Vec<_> = (0..n).map(|i| w.create_body_with_shape(&BodyDef::dynamic(vec3(0.0,0.5+i as Float,0.0)), &ShapeDef::default(), Shape::new_box(1.0,1.0,1.0)).unwrap().0).collect();
        let mut old: std::collections::HashMap<_,Vec<u32>> = Default::default();
        for i in 0..240 { w.try_step(h,sub()).unwrap(); let mut lost=0; let mut tot=0; let mut cnt=0;
            for id in &ids { for c in w.body(*id).unwrap().contacts() { let f: Vec<u32> = c.points[..c.count].iter().map(|p| p.feature).collect(); cnt+=1; tot+=f.len(); if let Some(o)=old.get(&c.contact) { lost+=f.iter().filter(|x| !o.contains(x)).count(); } old.insert(c.contact,f); } }
            if i%8==0 { let b=w.body(ids[n-1]).unwrap(); let t=b.transform(); println!("{i} contacts {cnt} points {tot} new {lost} top ({:.5},{:.5},{:.5}) w {:?}", t.p.x,t.p.y,t.p.z, b.angular_velocity()); } }
        let c = w.body(ids[5]).unwrap().contacts(); for c in c { println!("{:?}", c); }
    }
    if on("drop") { for (n,gap,jit) in [(10,0.01,0.0),(10,0.05,0.005),(20,0.01,0.0),(20,0.02,0.002)] {
        let mut w = World::try_new(&WorldDef{enable_sleep:false,contact_stiffness: std::env::var("ST").ok().and_then(|s| s.parse().ok()).unwrap_or(0.21), contact_damping_ratio: std::env::var("ZE").ok().and_then(|s| s.parse().ok()).unwrap_or(0.5),..Default::default()}).unwrap(); ground(&mut w, 0.6);
        let ids: Vec<_> = (0..n).map(|i| w.create_body_with_shape(&BodyDef::dynamic(vec3(jit*((i*7)%3) as Float,(0.5+gap)+i as Float*(1.0+gap),jit*((i*5)%4) as Float)), &ShapeDef::default(), Shape::new_box(1.0,1.0,1.0)).unwrap().0).collect();
        for i in 0..1200 { w.try_step(h,sub()).unwrap(); if [59,239,1199].contains(&i) { let r = w.step_report(); let t = w.body(ids[n-1]).unwrap().transform().p; println!("drop {n} gap {gap} jit {jit} t {} pen {:.5} mm top {:.5} drift {:e} ke {:e}", (i+1)/60, r.worst_penetration*1e3, t.y-(n as Float-0.5), (t.x*t.x+t.z*t.z).sqrt(), r.kinetic_energy); } }
    }
    for r in [10.0,100.0,1000.0] {
        let mut w = World::try_new(&WorldDef{enable_sleep:false,contact_stiffness: std::env::var("ST").ok().and_then(|s| s.parse().ok()).unwrap_or(0.21), contact_damping_ratio: std::env::var("ZE").ok().and_then(|s| s.parse().ok()).unwrap_or(0.5),..Default::default()}).unwrap(); ground(&mut w, 0.6);
        for i in 0..2 { let mut d = ShapeDef::default(); d.density = if i==0 {1.0} else {r}; w.create_body_with_shape(&BodyDef::dynamic(vec3(0.0,0.5+i as Float*1.1,0.0)), &d, Shape::new_box(1.0,1.0,1.0)).unwrap(); }
        for i in 0..1200 { w.try_step(h,sub()).unwrap(); if [59,239,1199].contains(&i) { let rp = w.step_report(); println!("dropheavy {r} t {} pen {:.5} mm ke {:e}", (i+1)/60, rp.worst_penetration*1e3, rp.kinetic_energy); } }
    }
    { let mut w = World::try_new(&WorldDef{enable_sleep:false,contact_stiffness: std::env::var("ST").ok().and_then(|s| s.parse().ok()).unwrap_or(0.21), contact_damping_ratio: std::env::var("ZE").ok().and_then(|s| s.parse().ok()).unwrap_or(0.5),..Default::default()}).unwrap(); ground(&mut w, 0.6);
      for i in 0..4 { for j in i..4 { w.create_body_with_shape(&BodyDef::dynamic(vec3((i as Float*0.5+(j-i) as Float)*0.75,0.375+i as Float*0.75,0.0)), &ShapeDef::default(), Shape::new_box(1.0,1.0,1.0)).unwrap(); } }
      let mut pk=0.0f64; for i in 0..600 { w.try_step(h,sub()).unwrap(); let rp = w.step_report(); pk=pk.max(rp.kinetic_energy/10000.0/10.0); if [30,60,120,599].contains(&i) { println!("overlap step {i}: pen {:.3} mm ke/mgL peak {pk:.4} now {:e}", rp.worst_penetration*1e3, rp.kinetic_energy); } } }
    }
    for r in [1.0,10.0,100.0,1000.0] { if on("heavy") {
        let mut w = World::try_new(&WorldDef{enable_sleep:false,enable_load_memory: std::env::var("MEM").is_err(), contact_stiffness: std::env::var("ST").ok().and_then(|s| s.parse().ok()).unwrap_or(0.21), contact_damping_ratio: std::env::var("ZE").ok().and_then(|s| s.parse().ok()).unwrap_or(0.5),..Default::default()}).unwrap(); ground(&mut w, 0.6);
        for i in 0..2 { let mut d = ShapeDef::default(); d.density = if i==0 {1.0} else {r}; w.create_body_with_shape(&BodyDef::dynamic(vec3(0.0,0.5+i as Float,0.0)), &d, Shape::new_box(1.0,1.0,1.0)).unwrap(); }
        for i in 0..1200 { w.try_step(h,sub()).unwrap(); if i%240==239 { let rp = w.step_report(); println!("heavy {r} t {} pen {:.5} mm ke {:e}", (i+1)/60, rp.worst_penetration*1e3, rp.kinetic_energy); } }
    }}
    for (rows, steps) in [(10,600),(100,200)] { if on(&format!("pyr{rows}")) {
        let mut w = World::try_new(&WorldDef{enable_sleep:false,enable_load_memory: std::env::var("MEM").is_err(), contact_stiffness: std::env::var("ST").ok().and_then(|s| s.parse().ok()).unwrap_or(0.21), contact_damping_ratio: std::env::var("ZE").ok().and_then(|s| s.parse().ok()).unwrap_or(0.5),..Default::default()}).unwrap();
        w.create_body_with_shape(&BodyDef::fixed(vec3(0.0,-1.0,0.0)), &ShapeDef::default(), Shape::new_box(800.0,2.0,800.0)).unwrap();
        let mut d = ShapeDef::default(); d.density=100.0;
        let mut top=None;
        for i in 0..rows { let y = 0.5 + i as Float; for j in i..rows { let x = (i as Float)*0.5 + (j-i) as Float - 0.5*rows as Float; top=Some(w.create_body_with_shape(&BodyDef::dynamic(vec3(x,y,0.0)), &d, Shape::new_box(1.0,1.0,1.0)).unwrap().0); } }
        let steps = std::env::var("STEPS").ok().and_then(|s| s.parse().ok()).unwrap_or(steps);
        let mut sum=Profile::default(); let mut best=f32::MAX;
        for i in 0..steps { w.try_step(h,sub()).unwrap(); if rows==100 && i%100==99 { let mut m=0.0 as Float; let mut mx=0.0 as Float; for b in w.bodies().collect::<Vec<_>>() { let b=w.body(b).unwrap(); m=m.max(b.transform().p.z.abs()); mx=mx.max(b.linear_velocity().z.abs()); } println!("   {i}: max|z| {m:e} vz {mx:e}"); } let p = w.profile(); if i>0 { best=best.min(p.step); sum.step+=p.step; sum.update_bounds+=p.update_bounds; sum.find_pairs+=p.find_pairs; sum.update_contacts+=p.update_contacts; sum.prepare+=p.prepare; sum.solve+=p.solve; sum.advance+=p.advance; sum.publish_events+=p.publish_events; sum.build_islands+=p.build_islands; sum.update_sleep+=p.update_sleep;} }
        let r = w.step_report(); let t = w.body(top.unwrap()).unwrap().transform().p;
        let n=(steps-1) as f32;
        println!("pyr {rows}: top {} side {} pen {:.4} mm ke {:e} contacts {} overflow {}", t.y, t.z, r.worst_penetration*1e3, r.kinetic_energy, r.counters.constraints, r.counters.overflow);
        println!("  ms/step {:.3} (best {:.3}): bounds {:.3} pairs {:.3} contacts {:.3} islands {:.3} prepare {:.3} solve {:.3} advance {:.3} sleep {:.3} events {:.3}", sum.step/n, best, sum.update_bounds/n, sum.find_pairs/n, sum.update_contacts/n, sum.build_islands/n, sum.prepare/n, sum.solve/n, sum.advance/n, sum.update_sleep/n, sum.publish_events/n);
    }}
    if on("bounce") {
        let mut worst: Vec<Float> = vec![0.0;5];
        for phase in 0..40 {
            let mut w = World::try_new(&WorldDef{enable_sleep:false,enable_load_memory: std::env::var("MEM").is_err(), contact_stiffness: std::env::var("ST").ok().and_then(|s| s.parse().ok()).unwrap_or(0.21), contact_damping_ratio: std::env::var("ZE").ok().and_then(|s| s.parse().ok()).unwrap_or(0.5),restitution_threshold:0.0,gravity:vec3(0.0,-9.81,0.0),..Default::default()}).unwrap(); 
            let mut d = ShapeDef::default(); d.material.restitution=0.8;
            w.create_body_with_shape(&BodyDef::fixed(vec3(0.0,-0.5,0.0)), &d, Shape::new_box(20.0,1.0,20.0)).unwrap();
            let h0 = 1.0 + phase as Float*0.002;
            let b = w.create_body_with_shape(&BodyDef::dynamic(vec3(0.0,0.1+h0,0.0)), &d, Shape::new_sphere(0.2)).unwrap().0;
            let mut peaks=vec![]; let (mut py, mut pv)=(0.0,0.0);
            for _ in 0..300 { w.try_step(h,sub()).unwrap(); let b=w.body(b).unwrap(); let (y,v)=(b.transform().p.y-0.1, b.linear_velocity().y);
                if pv>0.0 && v<=0.0 { peaks.push(py + pv*pv/(2.0*9.81)); } py=y; pv=v; }
            let mut e=h0; for k in 0..5 { e*=0.64; let err=(peaks.get(k).copied().unwrap_or(0.0)/e-1.0).abs(); worst[k]=worst[k].max(err); }
        }
        println!("bounce worst rel peak errors {worst:?}");
    }
    if on("slope") {
        for (mu, tan, secs) in [(0.5,0.98*0.5,10.0),(0.5,1.02*0.5,2.0),(0.4,0.5,2.0)] {
            let th: Float = merev::math::scalar::atan2(tan,1.0); 
            let q = quat_about(vec3(0.0,0.0,1.0), -th);
            let mut w = World::try_new(&WorldDef{enable_sleep:false,enable_load_memory: std::env::var("MEM").is_err(), contact_stiffness: std::env::var("ST").ok().and_then(|s| s.parse().ok()).unwrap_or(0.21), contact_damping_ratio: std::env::var("ZE").ok().and_then(|s| s.parse().ok()).unwrap_or(0.5),gravity:vec3(0.0,-9.81,0.0),..Default::default()}).unwrap();
            let mut d = ShapeDef::default(); d.material.friction=mu;
            let mut g = BodyDef::fixed(q*vec3(0.0,-0.5,0.0)); g.rotation=q;
            w.create_body_with_shape(&g, &d, Shape::new_box(100.0,1.0,100.0)).unwrap();
            let mut bd = BodyDef::dynamic(q*vec3(0.0,0.25,0.0)); bd.rotation=q;
            let b = w.create_body_with_shape(&bd, &d, Shape::new_box(1.0,0.5,1.0)).unwrap().0;
            let dir = q*vec3(1.0,0.0,0.0); let n=(secs*60.0) as i32; let mut at5=0.0;
            let x0 = w.body(b).unwrap().transform().p.dot(&dir);
            for i in 0..n { w.try_step(h,sub()).unwrap(); if i==n/2 { at5=w.body(b).unwrap().transform().p.dot(&dir)-x0; } }
            let x = w.body(b).unwrap().transform().p.dot(&dir)-x0;
            let t: Float = secs; let want = if tan>mu { 0.5*9.81*(scalar::sin(th)-mu*scalar::cos(th))*t*t } else {0.0};
            println!("slope mu {mu} tan {tan}: x {x} want {want} err {} creep {:e} m/s (2nd half)", if want>0.0 {x/want-1.0} else {0.0}, (x-at5)/(secs*0.5));
        }
    }
    if on("tumble") {
        let mut w = World::try_new(&WorldDef{enable_sleep:false,enable_load_memory: std::env::var("MEM").is_err(), contact_stiffness: std::env::var("ST").ok().and_then(|s| s.parse().ok()).unwrap_or(0.21), contact_damping_ratio: std::env::var("ZE").ok().and_then(|s| s.parse().ok()).unwrap_or(0.5),gravity:Vec3::zeros(),..Default::default()}).unwrap();
        let mut bd = BodyDef::dynamic(Vec3::zeros()); bd.angular_velocity=vec3(0.1,5.0,0.1);
        let mut d=ShapeDef::default(); d.density=10.0/(0.1*0.4*0.9);
        let b = w.create_body_with_shape(&bd, &d, Shape::new_box(0.1,0.4,0.9)).unwrap().0;
        let meas = |w:&World| { let b=w.body(b).unwrap(); let md=b.mass_data(); let q=b.transform().q; let wv=b.angular_velocity(); let l = rotate(&q, md.inertia*rotate_back(&q,wv)); (l, 0.5*l.dot(&wv)) };
        let (l0,e0)=meas(&w); let (mut dl,mut de):(Float,Float)=(0.0,0.0);
        for _ in 0..600 { w.try_step(h,sub()).unwrap(); let (l,e)=meas(&w); dl=dl.max(length(l-l0)/length(l0)); de=de.max((e-e0).abs()/e0); }
        println!("tumble dL {dl:e} dE {de:e}");
    }
}
