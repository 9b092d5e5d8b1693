const Sp="uplot",yp="u-hz",Ep="u-vt",bp="u-title",wp="u-wrap",Tp="u-under",Ap="u-over",Rp="u-axis",Ss="u-off",Cp="u-select",Pp="u-cursor-x",Lp="u-cursor-y",Dp="u-cursor-pt",Np="u-legend",Up="u-live",Ip="u-inline",Fp="u-series",Op="u-marker",bu="u-label",kp="u-value",Kr="width",jr="height";const wu="bottom",qs="left",Ha="right",Rc="#000",Tu=Rc+"0",Va="mousemove",Au="mousedown",Ga="mouseup",Ru="mouseenter",Cu="mouseleave",Pu="dblclick",Bp="resize",zp="scroll",Lu="change",ia="dppxchange",Cc="--",Ar=typeof window<"u",Pl=Ar?document:null,hr=Ar?window:null,Hp=Ar?navigator:null;let Mt,So;function Ll(){let i=devicePixelRatio;Mt!=i&&(Mt=i,So&&Nl(Lu,So,Ll),So=matchMedia(`(min-resolution: ${Mt-.001}dppx) and (max-resolution: ${Mt+.001}dppx)`),As(Lu,So,Ll),hr.dispatchEvent(new CustomEvent(ia)))}function Un(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Dl(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function It(i,e,t){i.style[e]=t+"px"}function Qn(i,e,t,n){let s=Pl.createElement(i);return e!=null&&Un(s,e),t?.insertBefore(s,n),s}function Vn(i,e){return Qn("div",i,e)}const Du=new WeakMap;function pi(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Du.get(i);r!=o&&(i.style.transform=r,Du.set(i,r),e<0||t<0||e>n||t>s?Un(i,Ss):Dl(i,Ss))}const Nu=new WeakMap;function Uu(i,e,t){let n=e+t,s=Nu.get(i);n!=s&&(Nu.set(i,n),i.style.background=e,i.style.borderColor=t)}const Iu=new WeakMap;function Fu(i,e,t,n){let s=e+""+t,r=Iu.get(i);s!=r&&(Iu.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}const Pc={passive:!0},Vp={...Pc,capture:!0};function As(i,e,t,n){e.addEventListener(i,t,n?Vp:Pc)}function Nl(i,e,t,n){e.removeEventListener(i,t,Pc)}Ar&&Ll();function ei(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:Fn((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Af(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}const Rf=i=>i!=null,Cf=i=>i!=null&&i>0,ma=Af(Rf),Gp=Af(Cf);function Wp(i,e,t,n=0,s=!1){let r=s?Gp:ma,o=s?Cf:Rf;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Ct,l??-Ct]}function ga(i,e,t,n){let s=Bu(i),r=Bu(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?Ui:Pf,a=s==1?Fn:Wn,l=r==1?Wn:Fn,c=a(o(Zt(i))),h=l(o(Zt(e))),u=mr(t,c),f=mr(t,h);return t==10&&(c<0&&(u=Pt(u,-c)),h<0&&(f=Pt(f,-h))),n||t==2?(i=u*s,e=f*r):(i=Uf(i,u),e=_a(e,f)),[i,e]}function Lc(i,e,t,n){let s=ga(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}const Dc=.1,Ou={mode:3,pad:Dc},eo={pad:0,soft:null,mode:0},$p={min:eo,max:eo};function sa(i,e,t,n){return va(t)?ku(i,e,t):(eo.pad=t,eo.soft=n?0:null,eo.mode=n?3:0,ku(i,e,$p))}function _t(i,e){return i??e}function Xp(i,e,t){for(e=_t(e,0),t=_t(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function ku(i,e,t){let n=t.min,s=t.max,r=_t(n.pad,0),o=_t(s.pad,0),a=_t(n.hard,-Ct),l=_t(s.hard,Ct),c=_t(n.soft,Ct),h=_t(s.soft,-Ct),u=_t(n.mode,0),f=_t(s.mode,0),g=e-i,_=Ui(g),v=Sn(Zt(i),Zt(e)),p=Ui(v),d=Zt(p-_);(g<1e-24||d>10)&&(g=0,(i==0||e==0)&&(g=1e-24,u==2&&c!=Ct&&(r=0),f==2&&h!=-Ct&&(o=0)));let w=g||v||1e3,T=Ui(w),y=mr(10,Fn(T)),z=w*(g==0?i==0?.1:1:r),L=Pt(Uf(i-z,y/10),24),D=i>=c&&(u==1||u==3&&L<=c||u==2&&L>=c)?c:Ct,N=Sn(a,L<D&&i>=D?D:ti(D,L)),b=w*(g==0?e==0?.1:1:o),S=Pt(_a(e+b,y/10),24),R=e<=h&&(f==1||f==3&&S>=h||f==2&&S<=h)?h:-Ct,V=ti(l,S>R&&e<=R?R:Sn(R,S));return N==V&&N==0&&(V=100),[N,V]}const qp=new Intl.NumberFormat(Ar?Hp.language:"en-US"),Nc=i=>qp.format(i),On=Math,jo=On.PI,Zt=On.abs,Fn=On.floor,jt=On.round,Wn=On.ceil,ti=On.min,Sn=On.max,mr=On.pow,Bu=On.sign,Ui=On.log10,Pf=On.log2,Yp=(i,e=1)=>On.sinh(i)*e,Wa=(i,e=1)=>On.asinh(i/e),Ct=1/0;function zu(i){return(Ui((i^i>>31)-(i>>31))|0)+1}function Ul(i,e,t){return ti(Sn(i,e),t)}function Lf(i){return typeof i=="function"}function ot(i){return Lf(i)?i:()=>i}const Kp=()=>{},Df=i=>i,Nf=(i,e)=>e,jp=i=>null,Hu=i=>!0,Vu=(i,e)=>i==e,Zp=/\.\d*?(?=9{6,}|0{6,})/gm,Ps=i=>{if(Ff(i)||ns.has(i))return i;const e=`${i}`,t=e.match(Zp);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Ps(s)}e${r}`}return Pt(i,n)};function vs(i,e){return Ps(Pt(Ps(i/e))*e)}function _a(i,e){return Ps(Wn(Ps(i/e))*e)}function Uf(i,e){return Ps(Fn(Ps(i/e))*e)}function Pt(i,e=0){if(Ff(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return jt(n)/t}const ns=new Map;function If(i){return((""+i).split(".")[1]||"").length}function io(i,e,t,n){let s=[],r=n.map(If);for(let o=e;o<t;o++){let a=Zt(o),l=Pt(mr(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?h:Pt(h,u);s.push(f),ns.set(f,u)}}return s}const to={},Uc=[],gr=[null,null],ji=Array.isArray,Ff=Number.isInteger,Jp=i=>i===void 0;function Gu(i){return typeof i=="string"}function va(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function Qp(i){return i!=null&&typeof i=="object"}const em=Object.getPrototypeOf(Uint8Array),Of="__proto__";function _r(i,e=va){let t;if(ji(i)){let n=i.find(s=>s!=null);if(ji(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=_r(i[s],e)}else t=i.slice()}else if(i instanceof em)t=i.slice();else if(e(i)){t={};for(let n in i)n!=Of&&(t[n]=_r(i[n],e))}else t=i;return t}function qt(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=Of&&(va(i[s])?qt(i[s],_r(n[s])):i[s]=_r(n[s]))}return i}const tm=0,nm=1,im=2;function sm(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function rm(i,e){if(lm(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return cm(o[0])||(o=am(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),f=e?e[o][c]:nm,g=[];for(let _=0;_<h.length;_++){let v=h[_],p=r.get(l[_]);v===null?f!=tm&&(u[p]=v,f==im&&g.push(p)):u[p]=v}sm(u,g,s),n.push(u)}}return n}const om=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function am(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function lm(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function cm(i,e=100){const t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;const r=Sn(1,Fn((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){const l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}const kf=["January","February","March","April","May","June","July","August","September","October","November","December"],Bf=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function zf(i){return i.slice(0,3)}const um=Bf.map(zf),hm=kf.map(zf),fm={MMMM:kf,MMM:hm,WWWW:Bf,WWW:um};function zr(i){return(i<10?"0":"")+i}function dm(i){return(i<10?"00":i<100?"0":"")+i}const pm={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>zr(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>zr(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>zr(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>zr(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>zr(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>dm(i.getMilliseconds())};function Ic(i,e){e=e||fm;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?pm[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}const mm=new Intl.DateTimeFormat().resolvedOptions().timeZone;function gm(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==mm?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}const Hf=i=>i%1==0,ra=[1,2,2.5,5],_m=io(10,-32,0,ra),Vf=io(10,0,32,ra),vm=Vf.filter(Hf),xs=_m.concat(Vf),Fc=`
`,Gf="{YYYY}",Wu=Fc+Gf,Wf="{M}/{D}",Zr=Fc+Wf,yo=Zr+"/{YY}",$f="{aa}",xm="{h}:{mm}",cr=xm+$f,$u=Fc+cr,Xu=":{ss}",Et=null;function Xf(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?io(10,0,3,ra).filter(Hf):io(10,-3,0,ra)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]);const c=[[o,Gf,Et,Et,Et,Et,Et,Et,1],[s*28,"{MMM}",Wu,Et,Et,Et,Et,Et,1],[s,Wf,Wu,Et,Et,Et,Et,Et,1],[n,"{h}"+$f,yo,Et,Zr,Et,Et,Et,1],[t,cr,yo,Et,Zr,Et,Et,Et,1],[e,Xu,yo+" "+cr,Et,Zr+" "+cr,Et,$u,Et,1],[i,Xu+".{fff}",yo+" "+cr,Et,Zr+" "+cr,Et,$u,Et,1]];function h(u){return(f,g,_,v,p,d)=>{let w=[],T=p>=o,y=p>=r&&p<o,z=u(_),L=Pt(z*i,3),D=$a(z.getFullYear(),T?0:z.getMonth(),y||T?1:z.getDate()),N=Pt(D*i,3);if(y||T){let b=y?p/r:0,S=T?p/o:0,R=L==N?L:Pt($a(D.getFullYear()+S,D.getMonth()+b,1)*i,3),V=new Date(jt(R/i)),I=V.getFullYear(),j=V.getMonth();for(let $=0;R<=v;$++){let Q=$a(I+S*$,j+b*$,1),J=Q-u(Pt(Q*i,3));R=Pt((+Q+J)*i,3),R<=v&&w.push(R)}}else{let b=p>=s?s:p,S=Fn(_)-Fn(L),R=N+S+_a(L-N,b);w.push(R);let V=u(R),I=V.getHours()+V.getMinutes()/t+V.getSeconds()/n,j=p/n,$=f.axes[g]._space,Q=d/$;for(;R=Pt(R+p,i==1?0:3),!(R>v);)if(j>1){let J=Fn(Pt(I+j,6))%24,he=u(R).getHours()-J;he>1&&(he=-1),R-=he*n,I=(I+j)%24;let _e=w[w.length-1];Pt((R-_e)/p,3)*Q>=.7&&w.push(R)}else w.push(R)}return w}}return[l,c,h]}const[Mm,Sm,ym]=Xf(1),[Em,bm,wm]=Xf(.001);io(2,-53,53,[1]);function qu(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Yu(i,e){return(t,n,s,r,o)=>{let a=e.find(_=>o>=_[0])||e[e.length-1],l,c,h,u,f,g;return n.map(_=>{let v=i(_),p=v.getFullYear(),d=v.getMonth(),w=v.getDate(),T=v.getHours(),y=v.getMinutes(),z=v.getSeconds(),L=p!=l&&a[2]||d!=c&&a[3]||w!=h&&a[4]||T!=u&&a[5]||y!=f&&a[6]||z!=g&&a[7]||a[1];return l=p,c=d,h=w,u=T,f=y,g=z,L(v)})}}function Tm(i,e){let t=Ic(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function $a(i,e,t){return new Date(i,e,t)}function Ku(i,e){return e(i)}const Am="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function ju(i,e){return(t,n,s,r)=>r==null?Cc:e(i(n))}function Rm(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function Cm(i,e){return i.series[e].fill(i,e)}const Pm={show:!0,live:!0,isolate:!1,mount:Kp,markers:{show:!0,width:2,stroke:Rm,fill:Cm,dash:"solid"},idx:null,idxs:null,values:[]};function Lm(i,e){let t=i.cursor.points,n=Vn(),s=t.size(i,e);It(n,Kr,s),It(n,jr,s);let r=s/-2;It(n,"marginLeft",r),It(n,"marginTop",r);let o=t.width(i,e,s);return o&&It(n,"borderWidth",o),n}function Dm(i,e){let t=i.series[e].points;return t._fill||t._stroke}function Nm(i,e){let t=i.series[e].points;return t._stroke||t._fill}function Um(i,e){return i.series[e].points.size}const Xa=[0,0];function Im(i,e,t){return Xa[0]=e,Xa[1]=t,Xa}function Eo(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function qa(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}const Fm={show:!0,x:!0,y:!0,lock:!1,move:Im,points:{one:!1,show:Lm,size:Um,width:0,stroke:Nm,fill:Dm},bind:{mousedown:Eo,mouseup:Eo,click:Eo,dblclick:Eo,mousemove:qa,mouseleave:qa,mouseenter:qa},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},qf={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Oc=qt({},qf,{filter:Nf}),Yf=qt({},Oc,{size:10}),Kf=qt({},qf,{show:!1}),kc='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',jf="bold "+kc,Zf=1.5,Zu={show:!0,scale:"x",stroke:Rc,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:jf,side:2,grid:Oc,ticks:Yf,border:Kf,font:kc,lineGap:Zf,rotate:0},Om="Value",km="Time",Ju={show:!0,scale:"x",auto:!1,sorted:1,min:Ct,max:-Ct,idxs:[]};function Bm(i,e,t,n,s){return e.map(r=>r==null?"":Nc(r))}function zm(i,e,t,n,s,r,o){let a=[],l=ns.get(s)||0;t=o?t:Pt(_a(t,s),l);for(let c=t;c<=n;c=Pt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Il(i,e,t,n,s,r,o){const a=[],l=i.scales[i.axes[e].scale].log,c=l==10?Ui:Pf,h=Fn(c(t));s=mr(l,h),l==10&&(s=xs[ei(s,xs)]);let u=t,f=s*l;l==10&&(f=xs[ei(f,xs)]);do a.push(u),u=u+s,l==10&&!ns.has(u)&&(u=Pt(u,ns.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=xs[ei(f,xs)]));while(u<=n);return a}function Hm(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?Il(i,e,Sn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?Il(i,e,Sn(l,-n),-t,s):[l]).reverse().map(f=>-f).concat(h,c)}const Jf=/./,Vm=/[12357]/,Gm=/[125]/,Qu=/1/,Fl=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Wm(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?Jf:l(7,o)-h>=c?Vm:l(5,o)-h>=c?Gm:Qu;if(u==Qu){let f=Zt(l(1,o)-h);if(f<c)return Fl(e.slice().reverse(),a.distr,u,Wn(c/f)).reverse()}return Fl(e,a.distr,u,1)}function $m(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=Zt(l(1,o)-l(2,o));return c<a?Fl(e.slice().reverse(),3,Jf,Wn(a/c)).reverse():e}function Xm(i,e,t,n){return n==null?Cc:e==null?"":Nc(e)}const eh={show:!0,scale:"y",stroke:Rc,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:jf,side:3,grid:Oc,ticks:Yf,border:Kf,font:kc,lineGap:Zf,rotate:0};function qm(i,e){let t=3+(i||1)*2;return Pt(t*e,3)}function Ym(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=Zt(o-r),l=i.series[e],c=a/(l.points.space*Mt);return n[1]-n[0]<=c}const th={scale:null,auto:!0,sorted:0,min:Ct,max:-Ct},Qf=(i,e,t,n,s)=>s,nh={show:!0,auto:!0,sorted:0,gaps:Qf,alpha:1,facets:[qt({},th,{scale:"x"}),qt({},th,{scale:"y"})]},ih={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Qf,alpha:1,points:{show:Ym,filter:null},values:null,min:Ct,max:-Ct,idxs:[],path:null,clip:null};function Km(i,e,t,n,s){return t/10}const ed={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},jm=qt({},ed,{time:!1,ori:1}),sh={};function td(i,e){let t=sh[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(sh[i]=t)),t}const vr=1,Ol=2;function Is(i,e,t){const n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox;let l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,g=a.top,_=a.width,v=a.height,p=i.valToPosH,d=i.valToPosV;return h.ori==0?t(s,l,c,h,u,p,d,f,g,_,v,Ma,Rr,ya,id,rd):t(s,l,c,h,u,d,p,g,f,v,_,Sa,Cr,Hc,sd,od)}function Bc(i,e){let t=0,n=0,s=_t(i.bands,Uc);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function Zm(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ii(i,e,t,n,s,r){return Is(i,e,(o,a,l,c,h,u,f,g,_,v,p)=>{let d=o.pxRound;const w=c.dir*(c.ori==0?1:-1),T=c.ori==0?Rr:Cr;let y,z;w==1?(y=t,z=n):(y=n,z=t);let L=d(u(a[y],c,v,g)),D=d(f(l[y],h,p,_)),N=d(u(a[z],c,v,g)),b=d(f(r==1?h.max:h.min,h,p,_)),S=new Path2D(s);return T(S,N,b),T(S,L,b),T(S,L,D),S})}function xa(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;const a=e==0?ya:Hc;let l=t;for(let u=0;u<i.length;u++){let f=i[u];if(f[1]>f[0]){let g=f[0]-l;g>0&&a(o,l,n,g,n+r),l=f[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function Jm(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function zc(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,f=c;if(s==1)for(;++c<=n&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let g=r(i[u]),_=f==u?g:r(i[f]),v=u-s;g=o<=0&&v>=0&&v<l?r(i[v]):g;let d=f+s;_=o>=0&&d>=0&&d<l?r(i[d]):_,_>=g&&a.push([g,_])}return a}function rh(i){return i==0?Df:i==1?jt:e=>vs(e,i)}function nd(i){let e=i==0?Ma:Sa,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=ti(c,a/2,l/2),h=ti(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}const Ma=(i,e,t)=>{i.moveTo(e,t)},Sa=(i,e,t)=>{i.moveTo(t,e)},Rr=(i,e,t)=>{i.lineTo(e,t)},Cr=(i,e,t)=>{i.lineTo(t,e)},ya=nd(0),Hc=nd(1),id=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},sd=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},rd=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},od=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function ad(i){return(e,t,n,s,r)=>Is(e,t,(o,a,l,c,h,u,f,g,_,v,p)=>{let{pxRound:d,points:w}=o,T,y;c.ori==0?(T=Ma,y=id):(T=Sa,y=sd);const z=Pt(w.width*Mt,3);let L=(w.size-w.width)/2*Mt,D=Pt(L*2,3),N=new Path2D,b=new Path2D,{left:S,top:R,width:V,height:I}=e.bbox;ya(b,S-D,R-D,V+D*2,I+D*2);const j=$=>{if(l[$]!=null){let Q=d(u(a[$],c,v,g)),J=d(f(l[$],h,p,_));T(N,Q+L,J),y(N,Q,J,L,0,jo*2)}};if(r)r.forEach(j);else for(let $=n;$<=s;$++)j($);return{stroke:z>0?N:null,fill:N,clip:b,flags:vr|Ol}})}function ld(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}const Qm=ld(Rr),eg=ld(Cr);function cd(i){const e=_t(i?.alignGaps,0);return(t,n,s,r)=>Is(t,n,(o,a,l,c,h,u,f,g,_,v,p)=>{[s,r]=ma(l,s,r);let d=o.pxRound,w=I=>d(u(I,c,v,g)),T=I=>d(f(I,h,p,_)),y,z;c.ori==0?(y=Rr,z=Qm):(y=Cr,z=eg);const L=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:vr},N=D.stroke;let b=!1;if(r-s>=v*4){let I=ge=>t.posToVal(ge,c.key,!0),j=null,$=null,Q,J,ne,de=w(a[L==1?s:r]),he=w(a[s]),_e=w(a[r]),ye=I(L==1?he+1:_e-1);for(let ge=L==1?s:r;ge>=s&&ge<=r;ge+=L){let re=a[ge],ve=(L==1?re<ye:re>ye)?de:w(re),le=l[ge];ve==de?le!=null?(J=le,j==null?(y(N,ve,T(J)),Q=j=$=J):J<j?j=J:J>$&&($=J)):le===null&&(b=!0):(j!=null&&z(N,de,T(j),T($),T(Q),T(J)),le!=null?(J=le,y(N,ve,T(J)),j=$=Q=J):(j=$=null,le===null&&(b=!0)),de=ve,ye=I(de+L))}j!=null&&j!=$&&ne!=de&&z(N,de,T(j),T($),T(Q),T(J))}else for(let I=L==1?s:r;I>=s&&I<=r;I+=L){let j=l[I];j===null?b=!0:j!=null&&y(N,w(a[I]),T(j))}let[R,V]=Bc(t,n);if(o.fill!=null||R!=0){let I=D.fill=new Path2D(N),j=o.fillTo(t,n,o.min,o.max,R),$=T(j),Q=w(a[s]),J=w(a[r]);L==-1&&([J,Q]=[Q,J]),y(I,J,$),y(I,Q,$)}if(!o.spanGaps){let I=[];b&&I.push(...zc(a,l,s,r,L,w,e)),D.gaps=I=o.gaps(t,n,s,r,I),D.clip=xa(I,c.ori,g,_,v,p)}return V!=0&&(D.band=V==2?[Ii(t,n,s,r,N,-1),Ii(t,n,s,r,N,1)]:Ii(t,n,s,r,N,V)),D})}function tg(i){const e=_t(i.align,1),t=_t(i.ascDesc,!1),n=_t(i.alignGaps,0),s=_t(i.extend,!1);return(r,o,a,l)=>Is(r,o,(c,h,u,f,g,_,v,p,d,w,T)=>{[a,l]=ma(u,a,l);let y=c.pxRound,{left:z,width:L}=r.bbox,D=he=>y(_(he,f,w,p)),N=he=>y(v(he,g,T,d)),b=f.ori==0?Rr:Cr;const S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:vr},R=S.stroke,V=f.dir*(f.ori==0?1:-1);let I=N(u[V==1?a:l]),j=D(h[V==1?a:l]),$=j,Q=j;s&&e==-1&&(Q=z,b(R,Q,I)),b(R,j,I);for(let he=V==1?a:l;he>=a&&he<=l;he+=V){let _e=u[he];if(_e==null)continue;let ye=D(h[he]),ge=N(_e);e==1?b(R,ye,I):b(R,$,ge),b(R,ye,ge),I=ge,$=ye}let J=$;s&&e==1&&(J=z+L,b(R,J,I));let[ne,de]=Bc(r,o);if(c.fill!=null||ne!=0){let he=S.fill=new Path2D(R),_e=c.fillTo(r,o,c.min,c.max,ne),ye=N(_e);b(he,J,ye),b(he,Q,ye)}if(!c.spanGaps){let he=[];he.push(...zc(h,u,a,l,V,D,n));let _e=c.width*Mt/2,ye=t||e==1?_e:-_e,ge=t||e==-1?-_e:_e;he.forEach(re=>{re[0]+=ye,re[1]+=ge}),S.gaps=he=c.gaps(r,o,a,l,he),S.clip=xa(he,f.ori,p,d,w,T)}return de!=0&&(S.band=de==2?[Ii(r,o,a,l,R,-1),Ii(r,o,a,l,R,1)]:Ii(r,o,a,l,R,de)),S})}function oh(i,e,t,n,s,r,o=Ct){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=Zt(i[l]-i[a]);h<c&&(c=h,o=Zt(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function ng(i){i=i||to;const e=_t(i.size,[.6,Ct,1]),t=i.align||0,n=i.gap||0;let s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=ot(s),o=1-e[0],a=_t(e[1],Ct),l=_t(e[2],1),c=_t(i.disp,to),h=_t(i.each,g=>{}),{fill:u,stroke:f}=c;return(g,_,v,p)=>Is(g,_,(d,w,T,y,z,L,D,N,b,S,R)=>{let V=d.pxRound,I=t,j=n*Mt,$=a*Mt,Q=l*Mt,J,ne;y.ori==0?[J,ne]=r(g,_):[ne,J]=r(g,_);const de=y.dir*(y.ori==0?1:-1);let he=y.ori==0?ya:Hc,_e=y.ori==0?h:(G,ie,Ee,xe,Ae,je,pe)=>{h(G,ie,Ee,Ae,xe,pe,je)},ye=_t(g.bands,Uc).find(G=>G.series[0]==_),ge=ye!=null?ye.dir:0,re=d.fillTo(g,_,d.min,d.max,ge),ce=V(D(re,z,R,b)),ve,le,He,Ge=S,Fe=V(d.width*Mt),lt=!1,Ze=null,ct=null,k=null,Yt=null;u!=null&&(Fe==0||f!=null)&&(lt=!0,Ze=u.values(g,_,v,p),ct=new Map,new Set(Ze).forEach(G=>{G!=null&&ct.set(G,new Path2D)}),Fe>0&&(k=f.values(g,_,v,p),Yt=new Map,new Set(k).forEach(G=>{G!=null&&Yt.set(G,new Path2D)})));let{x0:Qe,size:tt}=c;if(Qe!=null&&tt!=null){I=1,w=Qe.values(g,_,v,p),Qe.unit==2&&(w=w.map(Ee=>g.posToVal(N+Ee*S,y.key,!0)));let G=tt.values(g,_,v,p);tt.unit==2?le=G[0]*S:le=L(G[0],y,S,N)-L(0,y,S,N),Ge=oh(w,T,L,y,S,N,Ge),He=Ge-le+j}else Ge=oh(w,T,L,y,S,N,Ge),He=Ge*o+j,le=Ge-He;He<1&&(He=0),Fe>=le/2&&(Fe=0),He<5&&(V=Df);let We=He>0,ht=Ge-He-(We?Fe:0);le=V(Ul(ht,Q,$)),ve=(I==0?le/2:I==de?0:le)-I*de*((I==0?j/2:0)+(We?Fe/2:0));const De={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},C=lt?null:new Path2D;let M=null;if(ye!=null)M=g.data[ye.series[1]];else{let{y0:G,y1:ie}=c;G!=null&&ie!=null&&(T=ie.values(g,_,v,p),M=G.values(g,_,v,p))}let Z=J*le,ee=ne*le;for(let G=de==1?v:p;G>=v&&G<=p;G+=de){let ie=T[G];if(ie==null)continue;if(M!=null){let Be=M[G]??0;if(ie-Be==0)continue;ce=D(Be,z,R,b)}let Ee=y.distr!=2||c!=null?w[G]:G,xe=L(Ee,y,S,N),Ae=D(_t(ie,re),z,R,b),je=V(xe-ve),pe=V(Sn(Ae,ce)),Me=V(ti(Ae,ce)),Oe=pe-Me;if(ie!=null){let Be=ie<0?ee:Z,we=ie<0?Z:ee;lt?(Fe>0&&k[G]!=null&&he(Yt.get(k[G]),je,Me+Fn(Fe/2),le,Sn(0,Oe-Fe),Be,we),Ze[G]!=null&&he(ct.get(Ze[G]),je,Me+Fn(Fe/2),le,Sn(0,Oe-Fe),Be,we)):he(C,je,Me+Fn(Fe/2),le,Sn(0,Oe-Fe),Be,we),_e(g,_,G,je-Fe/2,Me,le+Fe,Oe)}}return Fe>0?De.stroke=lt?Yt:C:lt||(De._fill=d.width==0?d._fill:d._stroke??d._fill,De.width=0),De.fill=lt?ct:C,De})}function ig(i,e){const t=_t(e?.alignGaps,0);return(n,s,r,o)=>Is(n,s,(a,l,c,h,u,f,g,_,v,p,d)=>{[r,o]=ma(c,r,o);let w=a.pxRound,T=J=>w(f(J,h,p,_)),y=J=>w(g(J,u,d,v)),z,L,D;h.ori==0?(z=Ma,D=Rr,L=rd):(z=Sa,D=Cr,L=od);const N=h.dir*(h.ori==0?1:-1);let b=T(l[N==1?r:o]),S=b,R=[],V=[];for(let J=N==1?r:o;J>=r&&J<=o;J+=N)if(c[J]!=null){let de=l[J],he=T(de);R.push(S=he),V.push(y(c[J]))}const I={stroke:i(R,V,z,D,L,w),fill:null,clip:null,band:null,gaps:null,flags:vr},j=I.stroke;let[$,Q]=Bc(n,s);if(a.fill!=null||$!=0){let J=I.fill=new Path2D(j),ne=a.fillTo(n,s,a.min,a.max,$),de=y(ne);D(J,S,de),D(J,b,de)}if(!a.spanGaps){let J=[];J.push(...zc(l,c,r,o,N,T,t)),I.gaps=J=a.gaps(n,s,r,o,J),I.clip=xa(J,h.ori,_,v,p,d)}return Q!=0&&(I.band=Q==2?[Ii(n,s,r,o,j,-1),Ii(n,s,r,o,j,1)]:Ii(n,s,r,o,j,Q)),I})}function sg(i){return ig(rg,i)}function rg(i,e,t,n,s,r){const o=i.length;if(o<2)return null;const a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=e[f+1]-e[f],u[f]=i[f+1]-i[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+u[f]/3,e[f]+l[f]*u[f]/3,i[f+1]-u[f]/3,e[f+1]-l[f+1]*u[f]/3,i[f+1],e[f+1])}return a}const kl=new Set;function ah(){for(let i of kl)i.syncRect(!0)}Ar&&(As(Bp,hr,ah),As(zp,hr,ah,!0),As(ia,hr,()=>{mn.pxRatio=Mt}));const og=cd(),ag=ad();function lh(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Bl(r,o,e,t))}function lg(i,e){return i.map((t,n)=>n==0?{}:qt({},e,t))}function Bl(i,e,t,n){return qt({},e==0?t:n,i)}function ud(i,e,t){return e==null?gr:[e,t]}const cg=ud;function ug(i,e,t){return e==null?gr:sa(e,t,Dc,!0)}function hd(i,e,t,n){return e==null?gr:ga(e,t,i.scales[n].log,!1)}const hg=hd;function fd(i,e,t,n){return e==null?gr:Lc(e,t,i.scales[n].log,!1)}const fg=fd;function dg(i,e,t,n,s){let r=Sn(zu(i),zu(e)),o=e-i,a=ei(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?ns.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function ch(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=jt((t=+s)*Mt))+"px"),[i,e,t]}function pg(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Pt(e[2]*Mt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function mn(i,e,t){const n={mode:_t(i.mode,1)},s=n.mode;function r(m,x,A,P){let U=x.valToPct(m);return P+A*(x.dir==-1?1-U:U)}function o(m,x,A,P){let U=x.valToPct(m);return P+A*(x.dir==-1?U:1-U)}function a(m,x,A,P){return x.ori==0?r(m,x,A,P):o(m,x,A,P)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;const c=n.root=Vn(Sp);if(i.id!=null&&(c.id=i.id),Un(c,i.class),i.title){let m=Vn(bp,c);m.textContent=i.title}const h=Qn("canvas"),u=n.ctx=h.getContext("2d"),f=Vn(wp,c);As("click",f,m=>{m.target===_&&(Dt!=Vs||kt!=Gs)&&cn.click(n,m)},!0);const g=n.under=Vn(Tp,f);f.appendChild(h);const _=n.over=Vn(Ap,f);i=_r(i);const v=+_t(i.pxAlign,1),p=rh(v);(i.plugins||[]).forEach(m=>{m.opts&&(i=m.opts(n,i)||i)});const d=i.ms||.001,w=n.series=s==1?lh(i.series||[],Ju,ih,!1):lg(i.series||[null],nh),T=n.axes=lh(i.axes||[],Zu,eh,!0),y=n.scales={},z=n.bands=i.bands||[];z.forEach(m=>{m.fill=ot(m.fill||null),m.dir=_t(m.dir,-1)});const L=s==2?w[1].facets[0].scale:w[0].scale,D={axes:op,series:kn},N=(i.drawOrder||["axes","series"]).map(m=>D[m]);function b(m){const x=m.distr==3?A=>Ui(A>0?A:m.clamp(n,A,m.min,m.max,m.key)):m.distr==4?A=>Wa(A,m.asinh):m.distr==100?A=>m.fwd(A):A=>A;return A=>{let P=x(A),{_min:U,_max:K}=m,oe=K-U;return(P-U)/oe}}function S(m){let x=y[m];if(x==null){let A=(i.scales||to)[m]||to;if(A.from!=null){S(A.from);let P=qt({},y[A.from],A,{key:m});P.valToPct=b(P),y[m]=P}else{x=y[m]=qt({},m==L?ed:jm,A),x.key=m;let P=x.time,U=x.range,K=ji(U);if((m!=L||s==2&&!P)&&(K&&(U[0]==null||U[1]==null)&&(U={min:U[0]==null?Ou:{mode:1,hard:U[0],soft:U[0]},max:U[1]==null?Ou:{mode:1,hard:U[1],soft:U[1]}},K=!1),!K&&va(U))){let oe=U;U=(ue,me,Pe)=>me==null?gr:sa(me,Pe,oe)}x.range=ot(U||(P?cg:m==L?x.distr==3?hg:x.distr==4?fg:ud:x.distr==3?hd:x.distr==4?fd:ug)),x.auto=ot(K?!1:x.auto),x.clamp=ot(x.clamp||Km),x._min=x._max=null,x.valToPct=b(x)}}}S("x"),S("y"),s==1&&w.forEach(m=>{S(m.scale)}),T.forEach(m=>{S(m.scale)});for(let m in i.scales)S(m);const R=y[L],V=R.distr;let I,j;R.ori==0?(Un(c,yp),I=r,j=o):(Un(c,Ep),I=o,j=r);const $={};for(let m in y){let x=y[m];(x.min!=null||x.max!=null)&&($[m]={min:x.min,max:x.max},x.min=x.max=null)}const Q=i.tzDate||(m=>new Date(jt(m/d))),J=i.fmtDate||Ic,ne=d==1?ym(Q):wm(Q),de=Yu(Q,qu(d==1?Sm:bm,J)),he=ju(Q,Ku(Am,J)),_e=[],ye=n.legend=qt({},Pm,i.legend),ge=n.cursor=qt({},Fm,{drag:{y:s==2}},i.cursor),re=ye.show,ce=ge.show,ve=ye.markers;ye.idxs=_e,ve.width=ot(ve.width),ve.dash=ot(ve.dash),ve.stroke=ot(ve.stroke),ve.fill=ot(ve.fill);let le,He,Ge,Fe=[],lt=[],Ze,ct=!1,k={};if(ye.live){const m=w[1]?w[1].values:null;ct=m!=null,Ze=ct?m(n,1,0):{_:0};for(let x in Ze)k[x]=Cc}if(re)if(le=Qn("table",Np,c),Ge=Qn("tbody",null,le),ye.mount(n,le),ct){He=Qn("thead",null,le,Ge);let m=Qn("tr",null,He);Qn("th",null,m);for(var Yt in Ze)Qn("th",bu,m).textContent=Yt}else Un(le,Ip),ye.live&&Un(le,Up);const Qe={show:!0},tt={show:!1};function We(m,x){if(x==0&&(ct||!ye.live||s==2))return gr;let A=[],P=Qn("tr",Fp,Ge,Ge.childNodes[x]);Un(P,m.class),m.show||Un(P,Ss);let U=Qn("th",null,P);if(ve.show){let ue=Vn(Op,U);if(x>0){let me=ve.width(n,x);me&&(ue.style.border=me+"px "+ve.dash(n,x)+" "+ve.stroke(n,x)),ue.style.background=ve.fill(n,x)}}let K=Vn(bu,U);m.label instanceof HTMLElement?K.appendChild(m.label):K.textContent=m.label,x>0&&(ve.show||(K.style.color=m.width>0?ve.stroke(n,x):ve.fill(n,x)),De("click",U,ue=>{if(ge._lock)return;Kt(ue);let me=w.indexOf(m);if((ue.ctrlKey||ue.metaKey)!=ye.isolate){let Pe=w.some((Le,Ne)=>Ne>0&&Ne!=me&&Le.show);w.forEach((Le,Ne)=>{Ne>0&&ui(Ne,Pe?Ne==me?Qe:tt:Qe,!0,Wt.setSeries)})}else ui(me,{show:!m.show},!0,Wt.setSeries)},!1),Si&&De(Ru,U,ue=>{ge._lock||(Kt(ue),ui(w.indexOf(m),$s,!0,Wt.setSeries))},!1));for(var oe in Ze){let ue=Qn("td",kp,P);ue.textContent="--",A.push(ue)}return[P,A]}const ht=new Map;function De(m,x,A,P=!0){const U=ht.get(x)||{},K=ge.bind[m](n,x,A,P);K&&(As(m,x,U[m]=K),ht.set(x,U))}function C(m,x,A){const P=ht.get(x)||{};for(let U in P)(m==null||U==m)&&(Nl(U,x,P[U]),delete P[U]);m==null&&ht.delete(x)}let M=0,Z=0,ee=0,G=0,ie=0,Ee=0,xe=ie,Ae=Ee,je=ee,pe=G,Me=0,Oe=0,Be=0,we=0;n.bbox={};let it=!1,Ye=!1,ft=!1,O=!1,Se=!1,se=!1;function ae(m,x,A){(A||m!=n.width||x!=n.height)&&Re(m,x),ks(!1),ft=!0,Ye=!0,Bs()}function Re(m,x){n.width=M=ee=m,n.height=Z=G=x,ie=Ee=0,tn(),vt();let A=n.bbox;Me=A.left=vs(ie*Mt,.5),Oe=A.top=vs(Ee*Mt,.5),Be=A.width=vs(ee*Mt,.5),we=A.height=vs(G*Mt,.5)}const Ce=3;function Je(){let m=!1,x=0;for(;!m;){x++;let A=sp(x),P=rp(x);m=x==Ce||A&&P,m||(Re(n.width,n.height),Ye=!0)}}function Ft({width:m,height:x}){ae(m,x)}n.setSize=Ft;function tn(){let m=!1,x=!1,A=!1,P=!1;T.forEach((U,K)=>{if(U.show&&U._show){let{side:oe,_size:ue}=U,me=oe%2,Pe=U.label!=null?U.labelSize:0,Le=ue+Pe;Le>0&&(me?(ee-=Le,oe==3?(ie+=Le,P=!0):A=!0):(G-=Le,oe==0?(Ee+=Le,m=!0):x=!0))}}),ai[0]=m,ai[1]=A,ai[2]=x,ai[3]=P,ee-=E[1]+E[3],ie+=E[3],G-=E[2]+E[0],Ee+=E[0]}function vt(){let m=ie+ee,x=Ee+G,A=ie,P=Ee;function U(K,oe){switch(K){case 1:return m+=oe,m-oe;case 2:return x+=oe,x-oe;case 3:return A-=oe,A+oe;case 0:return P-=oe,P+oe}}T.forEach((K,oe)=>{if(K.show&&K._show){let ue=K.side;K._pos=U(ue,K._size),K.label!=null&&(K._lpos=U(ue,K.labelSize))}})}if(ge.dataIdx==null){let m=ge.hover,x=m.skip=new Set(m.skip??[]);x.add(void 0);let A=m.prox=ot(m.prox),P=m.bias??=0;ge.dataIdx=(U,K,oe,ue)=>{if(K==0)return oe;let me=oe,Pe=A(U,K,oe,ue)??Ct,Le=Pe>=0&&Pe<Ct,Ne=R.ori==0?ee:G,Ke=ge.left,xt=e[0],gt=e[K];if(x.has(gt[oe])){me=null;let st=null,Xe=null,Ve;if(P==0||P==-1)for(Ve=oe;st==null&&Ve-- >0;)x.has(gt[Ve])||(st=Ve);if(P==0||P==1)for(Ve=oe;Xe==null&&Ve++<gt.length;)x.has(gt[Ve])||(Xe=Ve);if(st!=null||Xe!=null)if(Le){let Ut=st==null?-1/0:I(xt[st],R,Ne,0),Ht=Xe==null?1/0:I(xt[Xe],R,Ne,0),an=Ke-Ut,Tt=Ht-Ke;an<=Tt?an<=Pe&&(me=st):Tt<=Pe&&(me=Xe)}else me=Xe==null?st:st==null?Xe:oe-st<=Xe-oe?st:Xe}else Le&&Zt(Ke-I(xt[oe],R,Ne,0))>Pe&&(me=null);return me}}const Kt=m=>{ge.event=m};ge.idxs=_e,ge._lock=!1;let Lt=ge.points;Lt.show=ot(Lt.show),Lt.size=ot(Lt.size),Lt.stroke=ot(Lt.stroke),Lt.width=ot(Lt.width),Lt.fill=ot(Lt.fill);const Rn=n.focus=qt({},i.focus||{alpha:.3},ge.focus),Si=Rn.prox>=0,En=Si&&Lt.one;let un=[],yi=[],Ei=[];function rs(m,x){let A=Lt.show(n,x);if(A instanceof HTMLElement)return Un(A,Dp),Un(A,m.class),pi(A,-10,-10,ee,G),_.insertBefore(A,un[x]),A}function Ur(m,x){if(s==1||x>0){let A=s==1&&y[m.scale].time,P=m.value;m.value=A?Gu(P)?ju(Q,Ku(P,J)):P||he:P||Xm,m.label=m.label||(A?km:Om)}if(En||x>0){m.width=m.width==null?1:m.width,m.paths=m.paths||og||jp,m.fillTo=ot(m.fillTo||Zm),m.pxAlign=+_t(m.pxAlign,v),m.pxRound=rh(m.pxAlign),m.stroke=ot(m.stroke||null),m.fill=ot(m.fill||null),m._stroke=m._fill=m._paths=m._focus=null;let A=qm(Sn(1,m.width),1),P=m.points=qt({},{size:A,width:Sn(1,A*.2),stroke:m.stroke,space:A*2,paths:ag,_stroke:null,_fill:null},m.points);P.show=ot(P.show),P.filter=ot(P.filter),P.fill=ot(P.fill),P.stroke=ot(P.stroke),P.paths=ot(P.paths),P.pxAlign=m.pxAlign}if(re){let A=We(m,x);Fe.splice(x,0,A[0]),lt.splice(x,0,A[1]),ye.values.push(null)}if(ce){_e.splice(x,0,null);let A=null;En?x==0&&(A=rs(m,x)):x>0&&(A=rs(m,x)),un.splice(x,0,A),yi.splice(x,0,0),Ei.splice(x,0,0)}on("addSeries",x)}function Fs(m,x){x=x??w.length,m=s==1?Bl(m,x,Ju,ih):Bl(m,x,{},nh),w.splice(x,0,m),Ur(w[x],x)}n.addSeries=Fs;function po(m){if(w.splice(m,1),re){ye.values.splice(m,1),lt.splice(m,1);let x=Fe.splice(m,1)[0];C(null,x.firstChild),x.remove()}ce&&(_e.splice(m,1),un.splice(m,1)[0].remove(),yi.splice(m,1),Ei.splice(m,1)),on("delSeries",m)}n.delSeries=po;const ai=[!1,!1,!1,!1];function Ca(m,x){if(m._show=m.show,m.show){let A=m.side%2,P=y[m.scale];P==null&&(m.scale=A?w[1].scale:L,P=y[m.scale]);let U=P.time;m.size=ot(m.size),m.space=ot(m.space),m.rotate=ot(m.rotate),ji(m.incrs)&&m.incrs.forEach(oe=>{!ns.has(oe)&&ns.set(oe,If(oe))}),m.incrs=ot(m.incrs||(P.distr==2?vm:U?d==1?Mm:Em:xs)),m.splits=ot(m.splits||(U&&P.distr==1?ne:P.distr==3?Il:P.distr==4?Hm:zm)),m.stroke=ot(m.stroke),m.grid.stroke=ot(m.grid.stroke),m.ticks.stroke=ot(m.ticks.stroke),m.border.stroke=ot(m.border.stroke);let K=m.values;m.values=ji(K)&&!ji(K[0])?ot(K):U?ji(K)?Yu(Q,qu(K,J)):Gu(K)?Tm(Q,K):K||de:K||Bm,m.filter=ot(m.filter||(P.distr>=3&&P.log==10?Wm:P.distr==3&&P.log==2?$m:Nf)),m.font=ch(m.font),m.labelFont=ch(m.labelFont),m._size=m.size(n,null,x,0),m._space=m._rotate=m._incrs=m._found=m._splits=m._values=null,m._size>0&&(ai[x]=!0,m._el=Vn(Rp,f))}}function os(m,x,A,P){let[U,K,oe,ue]=A,me=x%2,Pe=0;return me==0&&(ue||K)&&(Pe=x==0&&!U||x==2&&!oe?jt(Zu.size/3):0),me==1&&(U||oe)&&(Pe=x==1&&!K||x==3&&!ue?jt(eh.size/2):0),Pe}const mo=n.padding=(i.padding||[os,os,os,os]).map(m=>ot(_t(m,os))),E=n._padding=mo.map((m,x)=>m(n,x,ai,0));let F,W=null,X=null;const B=s==1?w[0].idxs:null;let fe=null,be=!1;function ke(m,x){if(e=m??[],n.data=n._data=e,s==2){F=0;for(let A=1;A<w.length;A++)F+=e[A][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),fe=e[0],F=fe.length;let A=e;if(V==2){A=e.slice();let P=A[0]=Array(F);for(let U=0;U<F;U++)P[U]=U}n._data=e=A}if(ks(!0),on("setData"),V==2&&(ft=!0),x!==!1){let A=R;A.auto(n,be)?Ue():zi(L,A.min,A.max),O=O||ge.left>=0,se=!0,Bs()}}n.setData=ke;function Ue(){be=!0;let m,x;s==1&&(F>0?(W=B[0]=0,X=B[1]=F-1,m=e[0][W],x=e[0][X],V==2?(m=W,x=X):m==x&&(V==3?[m,x]=ga(m,m,R.log,!1):V==4?[m,x]=Lc(m,m,R.log,!1):R.time?x=m+jt(86400/d):[m,x]=sa(m,x,Dc,!0))):(W=B[0]=m=null,X=B[1]=x=null)),zi(L,m,x)}let $e,qe,Ie,rt,yt,wt,nn,ut,ze,Ot;function dt(m,x,A,P,U,K){m??=Tu,A??=Uc,P??="butt",U??=Tu,K??="round",m!=$e&&(u.strokeStyle=$e=m),U!=qe&&(u.fillStyle=qe=U),x!=Ie&&(u.lineWidth=Ie=x),K!=yt&&(u.lineJoin=yt=K),P!=wt&&(u.lineCap=wt=P),A!=rt&&u.setLineDash(rt=A)}function bn(m,x,A,P){x!=qe&&(u.fillStyle=qe=x),m!=nn&&(u.font=nn=m),A!=ut&&(u.textAlign=ut=A),P!=ze&&(u.textBaseline=ze=P)}function li(m,x,A,P,U=0){if(P.length>0&&m.auto(n,be)&&(x==null||x.min==null)){let K=_t(W,0),oe=_t(X,P.length-1),ue=A.min==null?Wp(P,K,oe,U,m.distr==3):[A.min,A.max];m.min=ti(m.min,A.min=ue[0]),m.max=Sn(m.max,A.max=ue[1])}}const hn={min:null,max:null};function as(){for(let P in y){let U=y[P];$[P]==null&&(U.min==null||$[L]!=null&&U.auto(n,be))&&($[P]=hn)}for(let P in y){let U=y[P];$[P]==null&&U.from!=null&&$[U.from]!=null&&($[P]=hn)}$[L]!=null&&ks(!0);let m={};for(let P in $){let U=$[P];if(U!=null){let K=m[P]=_r(y[P],Qp);if(U.min!=null)qt(K,U);else if(P!=L||s==2)if(F==0&&K.from==null){let oe=K.range(n,null,null,P);K.min=oe[0],K.max=oe[1]}else K.min=Ct,K.max=-Ct}}if(F>0){w.forEach((P,U)=>{if(s==1){let K=P.scale,oe=$[K];if(oe==null)return;let ue=m[K];if(U==0){let me=ue.range(n,ue.min,ue.max,K);ue.min=me[0],ue.max=me[1],W=ei(ue.min,e[0]),X=ei(ue.max,e[0]),X-W>1&&(e[0][W]<ue.min&&W++,e[0][X]>ue.max&&X--),P.min=fe[W],P.max=fe[X]}else P.show&&P.auto&&li(ue,oe,P,e[U],P.sorted);P.idxs[0]=W,P.idxs[1]=X}else if(U>0&&P.show&&P.auto){let[K,oe]=P.facets,ue=K.scale,me=oe.scale,[Pe,Le]=e[U],Ne=m[ue],Ke=m[me];Ne!=null&&li(Ne,$[ue],K,Pe,K.sorted),Ke!=null&&li(Ke,$[me],oe,Le,oe.sorted),P.min=oe.min,P.max=oe.max}});for(let P in m){let U=m[P],K=$[P];if(U.from==null&&(K==null||K.min==null)){let oe=U.range(n,U.min==Ct?null:U.min,U.max==-Ct?null:U.max,P);U.min=oe[0],U.max=oe[1]}}}for(let P in m){let U=m[P];if(U.from!=null){let K=m[U.from];if(K.min==null)U.min=U.max=null;else{let oe=U.range(n,K.min,K.max,P);U.min=oe[0],U.max=oe[1]}}}let x={},A=!1;for(let P in m){let U=m[P],K=y[P];if(K.min!=U.min||K.max!=U.max){K.min=U.min,K.max=U.max;let oe=K.distr;K._min=oe==3?Ui(K.min):oe==4?Wa(K.min,K.asinh):oe==100?K.fwd(K.min):K.min,K._max=oe==3?Ui(K.max):oe==4?Wa(K.max,K.asinh):oe==100?K.fwd(K.max):K.max,x[P]=A=!0}}if(A){w.forEach((P,U)=>{s==2?U>0&&x.y&&(P._paths=null):x[P.scale]&&(P._paths=null)});for(let P in x)ft=!0,on("setScale",P);ce&&ge.left>=0&&(O=se=!0)}for(let P in $)$[P]=null}function Rt(m){let x=Ul(W-1,0,F-1),A=Ul(X+1,0,F-1);for(;m[x]==null&&x>0;)x--;for(;m[A]==null&&A<F-1;)A++;return[x,A]}function kn(){if(F>0){let m=w.some(x=>x._focus)&&Ot!=Rn.alpha;m&&(u.globalAlpha=Ot=Rn.alpha),w.forEach((x,A)=>{if(A>0&&x.show&&(ki(A,!1),ki(A,!0),x._paths==null)){let P=Ot;Ot!=x.alpha&&(u.globalAlpha=Ot=x.alpha);let U=s==2?[0,e[A][0].length-1]:Rt(e[A]);x._paths=x.paths(n,A,U[0],U[1]),Ot!=P&&(u.globalAlpha=Ot=P)}}),w.forEach((x,A)=>{if(A>0&&x.show){let P=Ot;Ot!=x.alpha&&(u.globalAlpha=Ot=x.alpha),x._paths!=null&&gn(A,!1);{let U=x._paths!=null?x._paths.gaps:null,K=x.points.show(n,A,W,X,U),oe=x.points.filter(n,A,K,U);(K||oe)&&(x.points._paths=x.points.paths(n,A,W,X,oe),gn(A,!0))}Ot!=P&&(u.globalAlpha=Ot=P),on("drawSeries",A)}}),m&&(u.globalAlpha=Ot=1)}}function ki(m,x){let A=x?w[m].points:w[m];A._stroke=A.stroke(n,m),A._fill=A.fill(n,m)}function gn(m,x){let A=x?w[m].points:w[m],{stroke:P,fill:U,clip:K,flags:oe,_stroke:ue=A._stroke,_fill:me=A._fill,_width:Pe=A.width}=A._paths;Pe=Pt(Pe*Mt,3);let Le=null,Ne=Pe%2/2;x&&me==null&&(me=Pe>0?"#fff":ue);let Ke=A.pxAlign==1&&Ne>0;if(Ke&&u.translate(Ne,Ne),!x){let xt=Me-Pe/2,gt=Oe-Pe/2,st=Be+Pe,Xe=we+Pe;Le=new Path2D,Le.rect(xt,gt,st,Xe)}x?Os(ue,Pe,A.dash,A.cap,me,P,U,oe,K):ci(m,ue,Pe,A.dash,A.cap,me,P,U,oe,Le,K),Ke&&u.translate(-Ne,-Ne)}function ci(m,x,A,P,U,K,oe,ue,me,Pe,Le){let Ne=!1;me!=0&&z.forEach((Ke,xt)=>{if(Ke.series[0]==m){let gt=w[Ke.series[1]],st=e[Ke.series[1]],Xe=(gt._paths||to).band;ji(Xe)&&(Xe=Ke.dir==1?Xe[0]:Xe[1]);let Ve,Ut=null;gt.show&&Xe&&Xp(st,W,X)?(Ut=Ke.fill(n,xt)||K,Ve=gt._paths.clip):Xe=null,Os(x,A,P,U,Ut,oe,ue,me,Pe,Le,Ve,Xe),Ne=!0}}),Ne||Os(x,A,P,U,K,oe,ue,me,Pe,Le)}const qn=vr|Ol;function Os(m,x,A,P,U,K,oe,ue,me,Pe,Le,Ne){dt(m,x,A,P,U),(me||Pe||Ne)&&(u.save(),me&&u.clip(me),Pe&&u.clip(Pe)),Ne?(ue&qn)==qn?(u.clip(Ne),Le&&u.clip(Le),_o(U,oe),go(m,K,x)):ue&Ol?(_o(U,oe),u.clip(Ne),go(m,K,x)):ue&vr&&(u.save(),u.clip(Ne),Le&&u.clip(Le),_o(U,oe),u.restore(),go(m,K,x)):(_o(U,oe),go(m,K,x)),(me||Pe||Ne)&&u.restore()}function go(m,x,A){A>0&&(x instanceof Map?x.forEach((P,U)=>{u.strokeStyle=$e=U,u.stroke(P)}):x!=null&&m&&u.stroke(x))}function _o(m,x){x instanceof Map?x.forEach((A,P)=>{u.fillStyle=qe=P,u.fill(A)}):x!=null&&m&&u.fill(x)}function ip(m,x,A,P){let U=T[m],K;if(P<=0)K=[0,0];else{let oe=U._space=U.space(n,m,x,A,P),ue=U._incrs=U.incrs(n,m,x,A,P,oe);K=dg(x,A,ue,P,oe)}return U._found=K}function Pa(m,x,A,P,U,K,oe,ue,me,Pe){let Le=oe%2/2;v==1&&u.translate(Le,Le),dt(ue,oe,me,Pe,ue),u.beginPath();let Ne,Ke,xt,gt,st=U+(P==0||P==3?-K:K);A==0?(Ke=U,gt=st):(Ne=U,xt=st);for(let Xe=0;Xe<m.length;Xe++)x[Xe]!=null&&(A==0?Ne=xt=m[Xe]:Ke=gt=m[Xe],u.moveTo(Ne,Ke),u.lineTo(xt,gt));u.stroke(),v==1&&u.translate(-Le,-Le)}function sp(m){let x=!0;return T.forEach((A,P)=>{if(!A.show)return;let U=y[A.scale];if(U.min==null){A._show&&(x=!1,A._show=!1,ks(!1));return}else A._show||(x=!1,A._show=!0,ks(!1));let K=A.side,oe=K%2,{min:ue,max:me}=U,[Pe,Le]=ip(P,ue,me,oe==0?ee:G);if(Le==0)return;let Ne=U.distr==2,Ke=A._splits=A.splits(n,P,ue,me,Pe,Le,Ne),xt=U.distr==2?Ke.map(Ve=>fe[Ve]):Ke,gt=U.distr==2?fe[Ke[1]]-fe[Ke[0]]:Pe,st=A._values=A.values(n,A.filter(n,xt,P,Le,gt),P,Le,gt);A._rotate=K==2?A.rotate(n,st,P,Le):0;let Xe=A._size;A._size=Wn(A.size(n,st,P,m)),Xe!=null&&A._size!=Xe&&(x=!1)}),x}function rp(m){let x=!0;return mo.forEach((A,P)=>{let U=A(n,P,ai,m);U!=E[P]&&(x=!1),E[P]=U}),x}function op(){for(let m=0;m<T.length;m++){let x=T[m];if(!x.show||!x._show)continue;let A=x.side,P=A%2,U,K,oe=x.stroke(n,m),ue=A==0||A==3?-1:1,[me,Pe]=x._found;if(x.label!=null){let vn=x.labelGap*ue,Ln=jt((x._lpos+vn)*Mt);bn(x.labelFont[0],oe,"center",A==2?"top":wu),u.save(),P==1?(U=K=0,u.translate(Ln,jt(Oe+we/2)),u.rotate((A==3?-jo:jo)/2)):(U=jt(Me+Be/2),K=Ln);let us=Lf(x.label)?x.label(n,m,me,Pe):x.label;u.fillText(us,U,K),u.restore()}if(Pe==0)continue;let Le=y[x.scale],Ne=P==0?Be:we,Ke=P==0?Me:Oe,xt=x._splits,gt=Le.distr==2?xt.map(vn=>fe[vn]):xt,st=Le.distr==2?fe[xt[1]]-fe[xt[0]]:me,Xe=x.ticks,Ve=x.border,Ut=Xe.show?Xe.size:0,Ht=jt(Ut*Mt),an=jt((x.alignTo==2?x._size-Ut-x.gap:x.gap)*Mt),Tt=x._rotate*-jo/180,Vt=p(x._pos*Mt),Cn=(Ht+an)*ue,_n=Vt+Cn;K=P==0?_n:0,U=P==1?_n:0;let Bn=x.font[0],Yn=x.align==1?qs:x.align==2?Ha:Tt>0?qs:Tt<0?Ha:P==0?"center":A==3?Ha:qs,fi=Tt||P==1?"middle":A==2?"top":wu;bn(Bn,oe,Yn,fi);let Pn=x.font[1]*x.lineGap,zn=xt.map(vn=>p(a(vn,Le,Ne,Ke))),Kn=x._values;for(let vn=0;vn<Kn.length;vn++){let Ln=Kn[vn];if(Ln!=null){P==0?U=zn[vn]:K=zn[vn],Ln=""+Ln;let us=Ln.indexOf(`
`)==-1?[Ln]:Ln.split(/\n/gm);for(let xn=0;xn<us.length;xn++){let Eu=us[xn];Tt?(u.save(),u.translate(U,K+xn*Pn),u.rotate(Tt),u.fillText(Eu,0,0),u.restore()):u.fillText(Eu,U,K+xn*Pn)}}}Xe.show&&Pa(zn,Xe.filter(n,gt,m,Pe,st),P,A,Vt,Ht,Pt(Xe.width*Mt,3),Xe.stroke(n,m),Xe.dash,Xe.cap);let di=x.grid;di.show&&Pa(zn,di.filter(n,gt,m,Pe,st),P,P==0?2:1,P==0?Oe:Me,P==0?we:Be,Pt(di.width*Mt,3),di.stroke(n,m),di.dash,di.cap),Ve.show&&Pa([Vt],[1],P==0?1:0,P==0?1:2,P==1?Oe:Me,P==1?we:Be,Pt(Ve.width*Mt,3),Ve.stroke(n,m),Ve.dash,Ve.cap)}on("drawAxes")}function ks(m){w.forEach((x,A)=>{A>0&&(x._paths=null,m&&(s==1?(x.min=null,x.max=null):x.facets.forEach(P=>{P.min=null,P.max=null})))})}let vo=!1,La=!1,Ir=[];function ap(){La=!1;for(let m=0;m<Ir.length;m++)on(...Ir[m]);Ir.length=0}function Bs(){vo||(om(ru),vo=!0)}function lp(m,x=!1){vo=!0,La=x,m(n),ru(),x&&Ir.length>0&&queueMicrotask(ap)}n.batch=lp;function ru(){if(it&&(as(),it=!1),ft&&(Je(),ft=!1),Ye){if(It(g,qs,ie),It(g,"top",Ee),It(g,Kr,ee),It(g,jr,G),It(_,qs,ie),It(_,"top",Ee),It(_,Kr,ee),It(_,jr,G),It(f,Kr,M),It(f,jr,Z),h.width=jt(M*Mt),h.height=jt(Z*Mt),T.forEach(({_el:m,_show:x,_size:A,_pos:P,side:U})=>{if(m!=null)if(x){let K=U===3||U===0?A:0,oe=U%2==1;It(m,oe?"left":"top",P-K),It(m,oe?"width":"height",A),It(m,oe?"top":"left",oe?Ee:ie),It(m,oe?"height":"width",oe?G:ee),Dl(m,Ss)}else Un(m,Ss)}),$e=qe=Ie=yt=wt=nn=ut=ze=rt=null,Ot=1,kr(!0),ie!=xe||Ee!=Ae||ee!=je||G!=pe){ks(!1);let m=ee/je,x=G/pe;if(ce&&!O&&ge.left>=0){ge.left*=m,ge.top*=x,zs&&pi(zs,jt(ge.left),0,ee,G),Hs&&pi(Hs,0,jt(ge.top),ee,G);for(let A=0;A<un.length;A++){let P=un[A];P!=null&&(yi[A]*=m,Ei[A]*=x,pi(P,Wn(yi[A]),Wn(Ei[A]),ee,G))}}if(Nt.show&&!Se&&Nt.left>=0&&Nt.width>0){Nt.left*=m,Nt.width*=m,Nt.top*=x,Nt.height*=x;for(let A in Oa)It(Ws,A,Nt[A])}xe=ie,Ae=Ee,je=ee,pe=G}on("setSize"),Ye=!1}M>0&&Z>0&&(u.clearRect(0,0,h.width,h.height),on("drawClear"),N.forEach(m=>m()),on("draw")),Nt.show&&Se&&(xo(Nt),Se=!1),ce&&O&&(cs(null,!0,!1),O=!1),ye.show&&ye.live&&se&&(Ia(),se=!1),l||(l=!0,n.status=1,on("ready")),be=!1,vo=!1}n.redraw=(m,x)=>{ft=x||!1,m!==!1?zi(L,R.min,R.max):Bs()};function Da(m,x){let A=y[m];if(A.from==null){if(F==0){let P=A.range(n,x.min,x.max,m);x.min=P[0],x.max=P[1]}if(x.min>x.max){let P=x.min;x.min=x.max,x.max=P}if(F>1&&x.min!=null&&x.max!=null&&x.max-x.min<1e-16)return;m==L&&A.distr==2&&F>0&&(x.min=ei(x.min,e[0]),x.max=ei(x.max,e[0]),x.min==x.max&&x.max++),$[m]=x,it=!0,Bs()}}n.setScale=Da;let Na,Ua,zs,Hs,ou,au,Vs,Gs,lu,cu,Dt,kt,Bi=!1;const cn=ge.drag;let sn=cn.x,rn=cn.y;ce&&(ge.x&&(Na=Vn(Pp,_)),ge.y&&(Ua=Vn(Lp,_)),R.ori==0?(zs=Na,Hs=Ua):(zs=Ua,Hs=Na),Dt=ge.left,kt=ge.top);const Nt=n.select=qt({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Ws=Nt.show?Vn(Cp,Nt.over?_:g):null;function xo(m,x){if(Nt.show){for(let A in m)Nt[A]=m[A],A in Oa&&It(Ws,A,m[A]);x!==!1&&on("setSelect")}}n.setSelect=xo;function cp(m){if(w[m].show)re&&Dl(Fe[m],Ss);else if(re&&Un(Fe[m],Ss),ce){let A=En?un[0]:un[m];A!=null&&pi(A,-10,-10,ee,G)}}function zi(m,x,A){Da(m,{min:x,max:A})}function ui(m,x,A,P){x.focus!=null&&pp(m),x.show!=null&&w.forEach((U,K)=>{K>0&&(m==K||m==null)&&(U.show=x.show,cp(K),s==2?(zi(U.facets[0].scale,null,null),zi(U.facets[1].scale,null,null)):zi(U.scale,null,null),Bs())}),A!==!1&&on("setSeries",m,x),P&&Br("setSeries",n,m,x)}n.setSeries=ui;function up(m,x){qt(z[m],x)}function hp(m,x){m.fill=ot(m.fill||null),m.dir=_t(m.dir,-1),x=x??z.length,z.splice(x,0,m)}function fp(m){m==null?z.length=0:z.splice(m,1)}n.addBand=hp,n.setBand=up,n.delBand=fp;function dp(m,x){w[m].alpha=x,ce&&un[m]!=null&&(un[m].style.opacity=x),re&&Fe[m]&&(Fe[m].style.opacity=x)}let bi,Hi,ls;const $s={focus:!0};function pp(m){if(m!=ls){let x=m==null,A=Rn.alpha!=1;w.forEach((P,U)=>{if(s==1||U>0){let K=x||U==0||U==m;P._focus=x?null:K,A&&dp(U,K?1:Rn.alpha)}}),ls=m,A&&Bs()}}re&&Si&&De(Cu,le,m=>{ge._lock||(Kt(m),ls!=null&&ui(null,$s,!0,Wt.setSeries))});function hi(m,x,A){let P=y[x];A&&(m=m/Mt-(P.ori==1?Ee:ie));let U=ee;P.ori==1&&(U=G,m=U-m),P.dir==-1&&(m=U-m);let K=P._min,oe=P._max,ue=m/U,me=K+(oe-K)*ue,Pe=P.distr;return Pe==3?mr(10,me):Pe==4?Yp(me,P.asinh):Pe==100?P.bwd(me):me}function mp(m,x){let A=hi(m,L,x);return ei(A,e[0],W,X)}n.valToIdx=m=>ei(m,e[0]),n.posToIdx=mp,n.posToVal=hi,n.valToPos=(m,x,A)=>y[x].ori==0?r(m,y[x],A?Be:ee,A?Me:0):o(m,y[x],A?we:G,A?Oe:0),n.setCursor=(m,x,A)=>{Dt=m.left,kt=m.top,cs(null,x,A)};function uu(m,x){It(Ws,qs,Nt.left=m),It(Ws,Kr,Nt.width=x)}function hu(m,x){It(Ws,"top",Nt.top=m),It(Ws,jr,Nt.height=x)}let Fr=R.ori==0?uu:hu,Or=R.ori==1?uu:hu;function gp(){if(re&&ye.live)for(let m=s==2?1:0;m<w.length;m++){if(m==0&&ct)continue;let x=ye.values[m],A=0;for(let P in x)lt[m][A++].firstChild.nodeValue=x[P]}}function Ia(m,x){if(m!=null&&(m.idxs?m.idxs.forEach((A,P)=>{_e[P]=A}):Jp(m.idx)||_e.fill(m.idx),ye.idx=_e[0]),re&&ye.live){for(let A=0;A<w.length;A++)(A>0||s==1&&!ct)&&_p(A,_e[A]);gp()}se=!1,x!==!1&&on("setLegend")}n.setLegend=Ia;function _p(m,x){let A=w[m],P=m==0&&V==2?fe:e[m],U;ct?U=A.values(n,m,x)??k:(U=A.value(n,x==null?null:P[x],m,x),U=U==null?k:{_:U}),ye.values[m]=U}function cs(m,x,A){lu=Dt,cu=kt,[Dt,kt]=ge.move(n,Dt,kt),ge.left=Dt,ge.top=kt,ce&&(zs&&pi(zs,jt(Dt),0,ee,G),Hs&&pi(Hs,0,jt(kt),ee,G));let P,U=W>X;bi=Ct,Hi=null;let K=R.ori==0?ee:G,oe=R.ori==1?ee:G;if(Dt<0||F==0||U){P=ge.idx=null;for(let ue=0;ue<w.length;ue++){let me=un[ue];me!=null&&pi(me,-10,-10,ee,G)}Si&&ui(null,$s,!0,m==null&&Wt.setSeries),ye.live&&(_e.fill(P),se=!0)}else{let ue,me,Pe;s==1&&(ue=R.ori==0?Dt:kt,me=hi(ue,L),P=ge.idx=ei(me,e[0],W,X),Pe=I(e[0][P],R,K,0));let Le=-10,Ne=-10,Ke=0,xt=0,gt=!0,st="",Xe="";for(let Ve=s==2?1:0;Ve<w.length;Ve++){let Ut=w[Ve],Ht=_e[Ve],an=Ht==null?null:s==1?e[Ve][Ht]:e[Ve][1][Ht],Tt=ge.dataIdx(n,Ve,P,me),Vt=Tt==null?null:s==1?e[Ve][Tt]:e[Ve][1][Tt];if(se=se||Vt!=an||Tt!=Ht,_e[Ve]=Tt,Ve>0&&Ut.show){let Cn=Tt==null?-10:Tt==P?Pe:I(s==1?e[0][Tt]:e[Ve][0][Tt],R,K,0),_n=Vt==null?-10:j(Vt,s==1?y[Ut.scale]:y[Ut.facets[1].scale],oe,0);if(Si&&Vt!=null){let Bn=R.ori==1?Dt:kt,Yn=Zt(Rn.dist(n,Ve,Tt,_n,Bn));if(Yn<bi){let fi=Rn.bias;if(fi!=0){let Pn=hi(Bn,Ut.scale),zn=Vt>=0?1:-1,Kn=Pn>=0?1:-1;Kn==zn&&(Kn==1?fi==1?Vt>=Pn:Vt<=Pn:fi==1?Vt<=Pn:Vt>=Pn)&&(bi=Yn,Hi=Ve)}else bi=Yn,Hi=Ve}}if(se||En){let Bn,Yn;R.ori==0?(Bn=Cn,Yn=_n):(Bn=_n,Yn=Cn);let fi,Pn,zn,Kn,di,vn,Ln=!0,us=Lt.bbox;if(us!=null){Ln=!1;let xn=us(n,Ve);zn=xn.left,Kn=xn.top,fi=xn.width,Pn=xn.height}else zn=Bn,Kn=Yn,fi=Pn=Lt.size(n,Ve);if(vn=Lt.fill(n,Ve),di=Lt.stroke(n,Ve),En)Ve==Hi&&bi<=Rn.prox&&(Le=zn,Ne=Kn,Ke=fi,xt=Pn,gt=Ln,st=vn,Xe=di);else{let xn=un[Ve];xn!=null&&(yi[Ve]=zn,Ei[Ve]=Kn,Fu(xn,fi,Pn,Ln),Uu(xn,vn,di),pi(xn,Wn(zn),Wn(Kn),ee,G))}}}}if(En){let Ve=Rn.prox,Ut=ls==null?bi<=Ve:bi>Ve||Hi!=ls;if(se||Ut){let Ht=un[0];Ht!=null&&(yi[0]=Le,Ei[0]=Ne,Fu(Ht,Ke,xt,gt),Uu(Ht,st,Xe),pi(Ht,Wn(Le),Wn(Ne),ee,G))}}}if(Nt.show&&Bi)if(m!=null){let[ue,me]=Wt.scales,[Pe,Le]=Wt.match,[Ne,Ke]=m.cursor.sync.scales,xt=m.cursor.drag;if(sn=xt._x,rn=xt._y,sn||rn){let{left:gt,top:st,width:Xe,height:Ve}=m.select,Ut=m.scales[Ne].ori,Ht=m.posToVal,an,Tt,Vt,Cn,_n,Bn=ue!=null&&Pe(ue,Ne),Yn=me!=null&&Le(me,Ke);Bn&&sn?(Ut==0?(an=gt,Tt=Xe):(an=st,Tt=Ve),Vt=y[ue],Cn=I(Ht(an,Ne),Vt,K,0),_n=I(Ht(an+Tt,Ne),Vt,K,0),Fr(ti(Cn,_n),Zt(_n-Cn))):Fr(0,K),Yn&&rn?(Ut==1?(an=gt,Tt=Xe):(an=st,Tt=Ve),Vt=y[me],Cn=j(Ht(an,Ke),Vt,oe,0),_n=j(Ht(an+Tt,Ke),Vt,oe,0),Or(ti(Cn,_n),Zt(_n-Cn))):Or(0,oe)}else ka()}else{let ue=Zt(lu-ou),me=Zt(cu-au);if(R.ori==1){let Ke=ue;ue=me,me=Ke}sn=cn.x&&ue>=cn.dist,rn=cn.y&&me>=cn.dist;let Pe=cn.uni;Pe!=null?sn&&rn&&(sn=ue>=Pe,rn=me>=Pe,!sn&&!rn&&(me>ue?rn=!0:sn=!0)):cn.x&&cn.y&&(sn||rn)&&(sn=rn=!0);let Le,Ne;sn&&(R.ori==0?(Le=Vs,Ne=Dt):(Le=Gs,Ne=kt),Fr(ti(Le,Ne),Zt(Ne-Le)),rn||Or(0,oe)),rn&&(R.ori==1?(Le=Vs,Ne=Dt):(Le=Gs,Ne=kt),Or(ti(Le,Ne),Zt(Ne-Le)),sn||Fr(0,K)),!sn&&!rn&&(Fr(0,0),Or(0,0))}if(cn._x=sn,cn._y=rn,m==null){if(A){if(yu!=null){let[ue,me]=Wt.scales;Wt.values[0]=ue!=null?hi(R.ori==0?Dt:kt,ue):null,Wt.values[1]=me!=null?hi(R.ori==1?Dt:kt,me):null}Br(Va,n,Dt,kt,ee,G,P)}if(Si){let ue=A&&Wt.setSeries,me=Rn.prox;ls==null?bi<=me&&ui(Hi,$s,!0,ue):bi>me?ui(null,$s,!0,ue):Hi!=ls&&ui(Hi,$s,!0,ue)}}se&&(ye.idx=P,Ia()),x!==!1&&on("setCursor")}let Vi=null;Object.defineProperty(n,"rect",{get(){return Vi==null&&kr(!1),Vi}});function kr(m=!1){m?Vi=null:(Vi=_.getBoundingClientRect(),on("syncRect",Vi))}function fu(m,x,A,P,U,K,oe){ge._lock||Bi&&m!=null&&m.movementX==0&&m.movementY==0||(Fa(m,x,A,P,U,K,oe,!1,m!=null),m!=null?cs(null,!0,!0):cs(x,!0,!1))}function Fa(m,x,A,P,U,K,oe,ue,me){if(Vi==null&&kr(!1),Kt(m),m!=null)A=m.clientX-Vi.left,P=m.clientY-Vi.top;else{if(A<0||P<0){Dt=-10,kt=-10;return}let[Pe,Le]=Wt.scales,Ne=x.cursor.sync,[Ke,xt]=Ne.values,[gt,st]=Ne.scales,[Xe,Ve]=Wt.match,Ut=x.axes[0].side%2==1,Ht=R.ori==0?ee:G,an=R.ori==1?ee:G,Tt=Ut?K:U,Vt=Ut?U:K,Cn=Ut?P:A,_n=Ut?A:P;if(gt!=null?A=Xe(Pe,gt)?a(Ke,y[Pe],Ht,0):-10:A=Ht*(Cn/Tt),st!=null?P=Ve(Le,st)?a(xt,y[Le],an,0):-10:P=an*(_n/Vt),R.ori==1){let Bn=A;A=P,P=Bn}}me&&(x==null||x.cursor.event.type==Va)&&((A<=1||A>=ee-1)&&(A=vs(A,ee)),(P<=1||P>=G-1)&&(P=vs(P,G))),ue?(ou=A,au=P,[Vs,Gs]=ge.move(n,A,P)):(Dt=A,kt=P)}const Oa={width:0,height:0,left:0,top:0};function ka(){xo(Oa,!1)}let du,pu,mu,gu;function _u(m,x,A,P,U,K,oe){Bi=!0,sn=rn=cn._x=cn._y=!1,Fa(m,x,A,P,U,K,oe,!0,!1),m!=null&&(De(Ga,Pl,vu,!1),Br(Au,n,Vs,Gs,ee,G,null));let{left:ue,top:me,width:Pe,height:Le}=Nt;du=ue,pu=me,mu=Pe,gu=Le}function vu(m,x,A,P,U,K,oe){Bi=cn._x=cn._y=!1,Fa(m,x,A,P,U,K,oe,!1,!0);let{left:ue,top:me,width:Pe,height:Le}=Nt,Ne=Pe>0||Le>0,Ke=du!=ue||pu!=me||mu!=Pe||gu!=Le;if(Ne&&Ke&&xo(Nt),cn.setScale&&Ne&&Ke){let xt=ue,gt=Pe,st=me,Xe=Le;if(R.ori==1&&(xt=me,gt=Le,st=ue,Xe=Pe),sn&&zi(L,hi(xt,L),hi(xt+gt,L)),rn)for(let Ve in y){let Ut=y[Ve];Ve!=L&&Ut.from==null&&Ut.min!=Ct&&zi(Ve,hi(st+Xe,Ve),hi(st,Ve))}ka()}else ge.lock&&(ge._lock=!ge._lock,cs(x,!0,m!=null));m!=null&&(C(Ga,Pl),Br(Ga,n,Dt,kt,ee,G,null))}function vp(m,x,A,P,U,K,oe){if(ge._lock)return;Kt(m);let ue=Bi;if(Bi){let me=!0,Pe=!0,Le=10,Ne,Ke;R.ori==0?(Ne=sn,Ke=rn):(Ne=rn,Ke=sn),Ne&&Ke&&(me=Dt<=Le||Dt>=ee-Le,Pe=kt<=Le||kt>=G-Le),Ne&&me&&(Dt=Dt<Vs?0:ee),Ke&&Pe&&(kt=kt<Gs?0:G),cs(null,!0,!0),Bi=!1}Dt=-10,kt=-10,_e.fill(null),cs(null,!0,!0),ue&&(Bi=ue)}function xu(m,x,A,P,U,K,oe){ge._lock||(Kt(m),Ue(),ka(),m!=null&&Br(Pu,n,Dt,kt,ee,G,null))}function Mu(){T.forEach(pg),ae(n.width,n.height,!0)}As(ia,hr,Mu);const Xs={};Xs.mousedown=_u,Xs.mousemove=fu,Xs.mouseup=vu,Xs.dblclick=xu,Xs.setSeries=(m,x,A,P)=>{let U=Wt.match[2];A=U(n,x,A),A!=-1&&ui(A,P,!0,!1)},ce&&(De(Au,_,_u),De(Va,_,fu),De(Ru,_,m=>{Kt(m),kr(!1)}),De(Cu,_,vp),De(Pu,_,xu),kl.add(n),n.syncRect=kr);const Mo=n.hooks=i.hooks||{};function on(m,x,A){La?Ir.push([m,x,A]):m in Mo&&Mo[m].forEach(P=>{P.call(null,n,x,A)})}(i.plugins||[]).forEach(m=>{for(let x in m.hooks)Mo[x]=(Mo[x]||[]).concat(m.hooks[x])});const Su=(m,x,A)=>A,Wt=qt({key:null,setSeries:!1,filters:{pub:Hu,sub:Hu},scales:[L,w[1]?w[1].scale:null],match:[Vu,Vu,Su],values:[null,null]},ge.sync);Wt.match.length==2&&Wt.match.push(Su),ge.sync=Wt;const yu=Wt.key,Ba=td(yu);function Br(m,x,A,P,U,K,oe){Wt.filters.pub(m,x,A,P,U,K,oe)&&Ba.pub(m,x,A,P,U,K,oe)}Ba.sub(n);function xp(m,x,A,P,U,K,oe){Wt.filters.sub(m,x,A,P,U,K,oe)&&Xs[m](null,x,A,P,U,K,oe)}n.pub=xp;function Mp(){Ba.unsub(n),kl.delete(n),ht.clear(),Nl(ia,hr,Mu),c.remove(),le?.remove(),on("destroy")}n.destroy=Mp;function za(){on("init",i,e),ke(e||i.data,!1),$[L]?Da(L,$[L]):Ue(),Se=Nt.show&&(Nt.width>0||Nt.height>0),O=se=!0,ae(i.width,i.height)}return w.forEach(Ur),T.forEach(Ca),t?t instanceof HTMLElement?(t.appendChild(c),za()):t(n,za):za(),n}mn.assign=qt;mn.fmtNum=Nc;mn.rangeNum=sa;mn.rangeLog=ga;mn.rangeAsinh=Lc;mn.orient=Is;mn.pxRatio=Mt;mn.join=rm;mn.fmtDate=Ic,mn.tzDate=gm;mn.sync=td;{mn.addGap=Jm,mn.clipGaps=xa;let i=mn.paths={points:ad};i.linear=cd,i.stepped=tg,i.bars=ng,i.spline=sg}function H(i,e={},...t){const n=document.createElement(i);for(const[s,r]of Object.entries(e))s.startsWith("on")?n.addEventListener(s.slice(2),r):s.includes("-")||s==="role"||s==="for"||s==="list"?n.setAttribute(s,String(r)):r!==void 0&&(n[s]=r);return n.append(...t.filter(s=>!!s)),n}function St(i,...e){i.replaceChildren(...e.filter(t=>!!t))}function bt(i,e,t={}){return H("button",{type:"button",onclick:e,...t},i)}let uh=0;function so(i){return uh+=1,`${i}-${uh}`}function ii(i,e,t){const n=so("slider"),s=u=>e.log?Math.log(u):u,r=u=>e.log?Math.exp(u):u,o=H("output",{for:n}),a=s(e.high)-s(e.low),l=H("input",{type:"range",id:n,min:String(s(e.low)),max:String(s(e.high)),step:String(e.step??a/200),"data-key":e.key??""}),c=u=>{o.textContent=e.show(u),l.setAttribute("aria-valuetext",e.show(u))};l.addEventListener("input",()=>{const u=r(Number(l.value));c(u),t(u)});const h=u=>{document.activeElement!==l&&(l.value=String(s(Math.max(u,e.log?e.low:-1/0)))),c(u)};return{root:H("div",{className:"slider"},H("label",{for:n},i),o,l),set:h}}function Ls(i,e,t,n,s=""){const r=so("select"),o=H("select",{id:r,"data-key":s,onchange:()=>n(o.value)},...e.map(([a,l])=>H("option",{value:a,selected:a===t},l)));return H("div",{className:"choice"},H("label",{for:r},i),o)}function zt(i,e=3){return Number.isFinite(i)?String(Number(i.toPrecision(e))).replace("-","−").replace("e","·10^"):"∞"}function oa(i,e,t=""){const n=i.length?H("thead",{},H("tr",{},...i.map(r=>H("th",{scope:"col"},r)))):null,s=H("tbody",{},...e.map(r=>H("tr",{},...r.map(o=>H("td",{},o)))));return H("div",{className:"table",tabIndex:0},H("table",{className:t},n,s))}function dd(i,e){let t=0,n=null;return(...s)=>{n=s,!t&&(e(...s),n=null,t=window.setTimeout(function r(){if(t=0,n){const o=n;n=null,e(...o),t=window.setTimeout(r,i)}},i))}}const mg={twin:"#0072b2",nonlinear:"#d55e00",linear:"#00805c",calibrated:"#a0478a",published:"#6b6b00"},gg={twin:"#56b4e9",nonlinear:"#f2843c",linear:"#2fc79b",calibrated:"#dd93bd",published:"#c9c95a"},_g={nonlinear:[7,4],linear:[2,3],calibrated:[9,3,2,3],published:[12,5]};function vg(){return document.documentElement.dataset.theme==="dark"}function Rs(i){return(vg()?gg:mg)[i]??"#888888"}function Vc(i){return _g[i]??[]}function xr(){const i=getComputedStyle(document.documentElement),e=t=>i.getPropertyValue(t).trim();return{text:e("--ink"),soft:e("--soft"),grid:e("--grid"),paper:e("--card"),push:e("--push")}}const xg=4,Ea={robot:"nxtway-gs",numbers:{},drive:"",kit:"nxt",noise:1,delay:-1,voltage:-1,dead_zone:-1,grip:10,bodies:["twin","nonlinear","linear"],controller:"lqg",largest:[],gains:[],payload:0,payload_height:.15,slope:0,seed:0},ba=["pitch","pitch_rate","wheel","wheel_rate","yaw","yaw_rate"],pd=["rad","rad/s","rad","rad/s","rad","rad/s"],Cs=["ψ","ψ̇","θ","θ̇","φ","φ̇"],hh=3200;class Mg{t=[];x=[];estimate=[];volts=[[],[]];saturated=[];reset(e){this.t=[],this.x=Array.from({length:e},()=>ba.map(()=>[])),this.estimate=[],this.volts=[[],[]],this.saturated=[]}add(e){const t=this.t.at(-1);t!==void 0&&e.t<=t||(e.x.length!==this.x.length&&this.reset(e.x.length),this.push(e.t,e.x,e.e[0]??NaN,e.x[0][6],e.x[0][7],e.s),this.t.length>hh+400&&this.cut(this.t.length-hh))}push(e,t,n,s,r,o){this.t.push(e),t.forEach((a,l)=>this.x[l].forEach((c,h)=>c.push(a[h]))),this.estimate.push(n),this.volts[0].push(s),this.volts[1].push(r),this.saturated.push(o)}until(e){let t=this.t.length;for(;t>0&&this.t[t-1]>=e;)t-=1;for(const n of this.all())n.length=t}cut(e){for(const t of this.all())t.splice(0,e)}all(){return[this.t,this.estimate,...this.volts,this.saturated,...this.x.flat()]}}class Sg{snapshot=null;traces=new Mg;changed=null;catalogue=null;analysed=null;equations=null;lit=null;board=null;found=null;role="alone";session="";files="";setup=Ea;replaying=!1;send=()=>{};listeners=[];listen(e){this.listeners.push(e)}change(e){this.setup={...this.setup,...e},this.send({kind:"Change",setup:this.setup})}hear(e){switch(e.kind){case"Snapshot":this.snapshot=e,e.back||this.traces.add(e);break;case"Welcome":this.role=e.role,this.session=e.session,this.files=e.files;break;case"Catalogue":this.catalogue=e;break;case"Changed":this.changedTo(e);break;case"Analysed":this.analysed=e;break;case"Equations":this.equations=e;break;case"Light":this.lit=e;break;case"Board":this.board=e;break;case"JobResult":this.found=e;break;case"History":this.filled(e.t,e.rows);break}for(const t of this.listeners)t(e)}changedTo(e){const t=this.changed?.bodies.join()===e.bodies.join();this.changed=e,this.setup=e.setup,t||this.traces.reset(e.bodies.length)}filled(e,t){const n=(t[0]?.length??0)/6;this.traces.reset(n),e.forEach((s,r)=>{const o=Array.from({length:n},(a,l)=>t[r].slice(6*l,6*l+6));this.traces.push(s,o,NaN,NaN,NaN,0)})}}const te=new Sg,yg="English",Eg="upright lab",bg="Skip to the controls",wg="Connecting …",Tg="Live",Ag="No connection; trying again",Rg="Recording",Cg="This page has stopped",Pg="Light or dark",Lg="Keys and mouse",Dg="Close",Ng="The robot in its room. Drag its body to push it; drag the floor to change the view.",Ug="{body} leans {pitch} degrees and has rolled {way} centimetres.",Ig="{body} has fallen.",Fg="twin",Og="nonlinear",kg="linear",Bg="published",zg="calibrated",Hg="MuJoCo; replaces hardware",Vg="Drag the robot to push it",Gg="It fell.",Wg="Stand up",$g="Tilt 0.1 rad",Xg="Pause",qg="Play",Yg="One period",Kg="Speed",jg="Back in time",Zg="now",Jg="Pushes",Qg="Hold front",e_="A force on the front that holds a lean of +0.1 rad for 3 s and is then released (the paper's first push)",t_="Hold back",n_="A force on the back that holds a lean of −0.12 rad for 3 s and is then released (the paper's second push)",i_="Knock",s_="Pull left wheel",r_="Pull right wheel",o_="Knock by",a_="Arrow keys drive and turn",l_="pitch",c_="pitch rate",u_="wheel angle",h_="wheel rate",f_="yaw",d_="yaw rate",p_="Traces of the last seconds",m_="Seconds shown",g_="Settings, views and files",__="Controller",v_="Robot",x_="Kit",M_="See",S_="Identify",y_="Keep",E_="Tour",b_="Class",w_="Method",T_="LQG: Kalman filter with dead time",A_="LQR with a Kalman filter",R_="LQI: LQG with an integral of the wheel angle",C_="PID cascade",P_="H∞",L_="MPC: predictive, keeps limits",D_="Sliding mode",N_="Robust: one gain for many robots",U_="Gains by hand: u = −K x",I_="No controller",F_="Largest accepted deviations (Bryson's rule): smaller means stricter",O_="command",k_="Back to the default weights",B_="This method has no weights to set here.",z_="Designing …",H_="Gain K on the left motor",V_="Gain K",G_="Margins at the motors",W_="gain",$_="phase",X_="more delay",q_="unlimited",Y_="Certificate",K_="green: may drive",j_="amber: with care",Z_="red: should not drive",J_="computing …",Q_="none",e0="Full certificate",t0="Robot",n0="Open robot.toml",i0="Parameters",s0="The controller is designed for these parameters.",r0="Back to the preset's parameters",o0="Payload unknown to the controller",a0="Height of the payload above the axle",l0="Slope of the floor",c0="Grip of the wheels (twin)",u0="Bodies to compare",h0="Electronics",f0="ideal: nothing between controller and motors",d0="Noise, quanta and bias of the sensors",p0="Dead time",m0="Battery",g0="Dead zone of the motors",_0="Back to the kit's values",v0="Loop",x0="Bode plot of the loop broken at both motors",M0="Nyquist plot",S0="Closed-loop poles",y0="Phase portrait",E0="Voltage",b0="Voltage at the left and right motor; bars mark saturation.",w0="Torque of the left and right motor; bars mark saturation.",T0="Estimate",A0="The controller's estimate of the pitch, and the true pitch.",R0="This controller estimates no state: it reads the true state, or nothing.",C0="Equations",P0="v in volts, or in the unit of the torque. Dry and rolling friction, slope and pushes are added to these.",L0="left",D0="right",N0="truth",U0="estimate",I0="saturated",F0="Linearised about upright, ẋ = A x + B u",O0="Open-loop poles",k0="Log to use",B0="this run (the last minute)",z0="Open a log",H0="Doctor",V0="Finds faults of the log: units, signs, delays, bias …",G0="Calibrate",W0="Estimates the robot's parameters from its raw sensors; the calibrated model is shown as a further trace",$0="Compare",X0="A page with numbers and figures of all bodies over the last minute",q0="Stop",Y0="A calibration needs motion: push and drive the robot for half a minute first.",K0="Log",j0="The files hold the run since the last change, at most the last minute.",Z0="Log as CSV",J0="Log as Parquet",Q0="Report",ev="Replay page",tv="Controller file",nv="Robot file",iv="Picture",sv="Copy link",rv="Link copied. It restores this whole set-up.",ov="{name} is ready",av="Recovered from {impulse} N s; largest so far {best} N s",lv="Fell after {impulse} N s",cv="Reading {name}",uv="{force} N",hv="Board",fv="Name",dv="Largest push [N s]",pv="Effort",mv="Send my set-up to everyone",gv="Your name",_v="Token",vv="Join",xv="Join the class",Mv="Step {n} of 8",Sv="Do",yv="Watch",Ev="Think",bv="Set it up",wv="Next",Tv="Previous",Av=[["Mouse on the robot","drag and hold to push"],["Mouse on the floor","drag to change the view, scroll to zoom"],["← → ↑ ↓","turn and drive; a gamepad's left stick does the same"],["F, B","push from the front, from the back, while the key is held"],["K","knock"],["Space","pause and continue"],[".","one period"],[", and /","back and forth in time, while paused"],["S","stand up"],["1 … 8","open a tab"],["N, P","next and previous step of the tour; Enter sets it up"],["[ ] { } + −","change the view and zoom, while the room has the focus"],["?","this list"]],Rv=[{title:"It falls by itself",do:"There is no controller. The robot starts with a lean of 0.02 rad.",watch:"ψ grows like an exponential, because one open-loop pole lies in the right half-plane.",ask:"How long until the lean has doubled? Compare with ln 2 divided by the unstable pole (See, Equations)."},{title:"Linearise",do:"Only the two models start, without a controller, from a small lean.",watch:"At first the nonlinear and the linear trace agree. They separate at about 0.5 rad.",ask:"Which term of the equations does the linear model approximate? Look at sin ψ."},{title:"Regulate",do:"An LQR balances it now. Tilt it, and change the accepted pitch under Controller.",watch:"Smaller accepted pitch: larger gain, quicker return, more voltage.",ask:"How do the margins change when the accepted pitch gets smaller? What is the price of a quick return?"},{title:"Push the front",do:"Press Hold front: a force on the front holds ψ at 0.1 rad, and is then released.",watch:"The robot leans into the force. After the release it rolls, overshoots and comes back.",ask:"Why does a push on the front hold a forward lean? Think of the sum of moments."},{title:"Push the back",do:"Press Hold back: −0.12 rad, then released.",watch:"The same response, mirrored and a little larger. φ hardly moves.",ask:"Is the response exactly the mirror image? What would make the two sides differ?"},{title:"Compare",do:"Push twin and models in the same way. Then open Identify and press Compare.",watch:"Shapes agree, settling times differ: the linear model settles differently from the others.",ask:"Which of the six signals differs most, and which physical effect is behind it?"},{title:"Break the linear model",do:"The robot carries a payload that neither the controller nor the linear model includes. Push harder.",watch:"The linear ghost moves differently; the twin sways or falls.",ask:"How large a payload does the margin allow? Find the limit."},{title:"Make it robust",do:"A robust design has one gain for many robots. Repeat your pushes.",watch:"It balances where the previous regulator fell, perhaps more slowly. The light of the certificate shows the risk.",ask:"What did robustness cost? Compare effort and travel in a report."}],Cv="This robot cannot be simulated. The one before it stands here again.",Pv="That was too much at once: some of it was left out. Wait a moment.",Lv="The simulation stopped and was started again. All robots stand upright.",Dv="Your last change stopped the simulation for all. The usual robot stands here instead.",Gc={language:yg,title:Eg,skip:bg,connecting:wg,connected:Tg,lost:Ag,replaying:Rg,refused:Cg,theme:Pg,help:Lg,close:Dg,scene:Ng,sceneNow:Ug,fellNow:Ig,twin:Fg,nonlinear:Og,linear:kg,published:Bg,calibrated:zg,twinNote:Hg,hint:Vg,fallen:Gg,standUp:Wg,tilt:$g,pause:Xg,play:qg,step:Yg,speed:Kg,back:jg,now:Zg,pushes:Jg,front:Qg,frontTip:e_,backPush:t_,backTip:n_,impulse:i_,pullLeft:s_,pullRight:r_,size:o_,drive:a_,pitch:l_,pitch_rate:c_,wheel:u_,wheel_rate:h_,yaw:f_,yaw_rate:d_,charts:p_,window:m_,tabs:g_,tabController:__,tabRobot:v_,tabKit:x_,tabSee:M_,tabIdentify:S_,tabKeep:y_,tabTour:E_,tabClass:b_,family:w_,lqg:T_,lqr:A_,"lqr-complementary":"LQR with a complementary filter","lqr-state":"LQR on the true state (simulation only)",lqi:R_,pid:C_,hinf:P_,mpc:L_,sliding:D_,robust:N_,gains:U_,off:I_,weights:F_,command:O_,ownWeights:k_,noWeights:B_,designing:z_,gain:H_,gainBoth:V_,margins:G_,gainMargin:W_,phaseMargin:$_,delayMargin:X_,unlimited:q_,certificate:Y_,green:K_,amber:j_,red:Z_,none:J_,noCertificate:Q_,fullCertificate:e0,preset:t0,openRobot:n0,numbers:i0,numbersNote:s0,ownNumbers:r0,payload:o0,payloadHeight:a0,slope:l0,grip:c0,bodies:u0,kit:h0,ideal:f0,noise:d0,delay:p0,voltage:m0,deadZone:g0,ownKit:_0,loop:v0,bode:x0,nyquist:M0,poles:S0,portrait:y0,voltages:E0,voltagesNote:b0,torquesNote:w0,estimate:T0,estimateNote:A0,noEstimate:R0,equations:C0,equationsNote:P0,leftMotor:L0,rightMotor:D0,truth:N0,opinion:U0,saturated:I0,linearised:F0,openPoles:O0,source:k0,thisRun:B0,openLog:z0,doctor:H0,doctorTip:V0,calibrate:G0,calibrateTip:W0,compare:$0,compareTip:X0,stop:q0,calibrateNote:Y0,log:K0,keepNote:j0,csv:Z0,parquet:J0,report:Q0,replay:ev,controllerFile:tv,robotFile:nv,picture:iv,link:sv,linkCopied:rv,made:ov,recovered:av,lostPush:lv,uploaded:cv,newtons:uv,board:hv,name:fv,bestPush:dv,effort:pv,broadcast:mv,yourName:gv,token:_v,enter:vv,joinTitle:xv,tourStep:Mv,tourDo:Sv,tourWatch:yv,tourAsk:Ev,tourSet:bv,next:wv,previous:Tv,keys:Av,tour:Rv,setBack:Cv,tooMany:Pv,restarted:Lv,ended:Dv},Nv="Español",Uv="lab upright",Iv="Ir a los controles",Fv="Conectando …",Ov="En vivo",kv="Sin conexión; se intenta de nuevo",Bv="Grabación",zv="Esta página se ha detenido",Hv="Claro u oscuro",Vv="Teclas y ratón",Gv="Cerrar",Wv="El robot en su sala. Arrastre su cuerpo para empujarlo; arrastre el suelo para cambiar la vista.",$v="{body} se inclina {pitch} grados y ha rodado {way} centímetros.",Xv="{body} se ha caído.",qv="gemelo",Yv="no lineal",Kv="lineal",jv="publicado",Zv="calibrado",Jv="MuJoCo; sustituye al robot real",Qv="Arrastre el robot para empujarlo",ex="Se cayó.",tx="Poner de pie",nx="Inclinar 0,1 rad",ix="Pausa",sx="Continuar",rx="Un período",ox="Velocidad",ax="Atrás en el tiempo",lx="ahora",cx="Empujones",ux="Sostener por delante",hx="Una fuerza por delante que mantiene +0,1 rad durante 3 s y luego cesa (el primer empujón del artículo)",fx="Sostener por detrás",dx="Una fuerza por detrás que mantiene −0,12 rad durante 3 s y luego cesa (el segundo empujón del artículo)",px="Golpe",mx="Tirar de la rueda izquierda",gx="Tirar de la rueda derecha",_x="Golpe de",vx="Las flechas conducen y giran",xx="inclinación",Mx="velocidad de inclinación",Sx="ángulo de ruedas",yx="velocidad de ruedas",Ex="rumbo",bx="velocidad de giro",wx="Trazas de los últimos segundos",Tx="Segundos mostrados",Ax="Ajustes, vistas y archivos",Rx="Controlador",Cx="Robot",Px="Electrónica",Lx="Ver",Dx="Identificar",Nx="Guardar",Ux="Recorrido",Ix="Clase",Fx="Método",Ox="LQG: filtro de Kalman con retardo",kx="LQR con filtro de Kalman",Bx="LQI: LQG con integral del ángulo de ruedas",zx="PID en cascada",Hx="H∞",Vx="MPC: predictivo, respeta límites",Gx="Modo deslizante",Wx="Robusto: una ganancia para muchos robots",$x="Ganancias a mano: u = −K x",Xx="Sin controlador",qx="Mayores desviaciones aceptadas (regla de Bryson): menor es más estricto",Yx="mando",Kx="Volver a los pesos predeterminados",jx="Este método no tiene pesos que ajustar aquí.",Zx="Diseñando …",Jx="Ganancia K del motor izquierdo",Qx="Ganancia K",eM="Márgenes en los motores",tM="ganancia",nM="fase",iM="más retardo",sM="sin límite",rM="Certificado",oM="verde: puede conducir",aM="ámbar: con cuidado",lM="rojo: no debe conducir",cM="calculando …",uM="ninguno",hM="Certificado completo",fM="Robot",dM="Abrir robot.toml",pM="Parámetros",mM="El controlador se diseña para estos parámetros.",gM="Volver a los parámetros del preajuste",_M="Carga que el controlador desconoce",vM="Altura de la carga sobre el eje",xM="Pendiente del suelo",MM="Agarre de las ruedas (gemelo)",SM="Cuerpos que se comparan",yM="Electrónica",EM="ideal: nada entre controlador y motores",bM="Ruido, cuantos y sesgo de los sensores",wM="Retardo",TM="Batería",AM="Zona muerta de los motores",RM="Volver a los valores de la electrónica",CM="Lazo",PM="Diagrama de Bode del lazo abierto en ambos motores",LM="Diagrama de Nyquist",DM="Polos en lazo cerrado",NM="Plano de fase",UM="Tensión",IM="Tensión en el motor izquierdo y en el derecho; las barras marcan saturación.",FM="Par del motor izquierdo y del derecho; las barras marcan saturación.",OM="Estimación",kM="La inclinación estimada por el controlador y la verdadera.",BM="Este controlador no estima el estado: lee el verdadero, o nada.",zM="Ecuaciones",HM="v en voltios, o en la unidad del par. A esto se suman fricción seca y de rodadura, pendiente y empujones.",VM="izquierdo",GM="derecho",WM="verdad",$M="estimación",XM="saturado",qM="Linealizado en vertical, ẋ = A x + B u",YM="Polos en lazo abierto",KM="Registro que se usa",jM="este ensayo (el último minuto)",ZM="Abrir un registro",JM="Doctor",QM="Busca fallos del registro: unidades, signos, retardos, sesgo …",eS="Calibrar",tS="Estima los parámetros del robot a partir de sus sensores; el modelo calibrado se muestra como otra traza",nS="Comparar",iS="Una página con números y figuras de todos los cuerpos en el último minuto",sS="Parar",rS="Una calibración necesita movimiento: empuje y conduzca el robot medio minuto antes.",oS="Registro",aS="Los archivos contienen el ensayo desde el último cambio, como mucho el último minuto.",lS="Registro CSV",cS="Registro Parquet",uS="Informe",hS="Página con la grabación",fS="Archivo del controlador",dS="Archivo del robot",pS="Imagen",mS="Copiar enlace",gS="Enlace copiado. Restaura toda esta configuración.",_S="{name} está listo",vS="Se recuperó de {impulse} N s; el mayor hasta ahora {best} N s",xS="Se cayó tras {impulse} N s",MS="Se está leyendo {name}",SS="{force} N",yS="Clasificación",ES="Nombre",bS="Mayor empujón [N s]",wS="Esfuerzo",TS="Enviar mi configuración a todos",AS="Su nombre",RS="Clave",CS="Entrar",PS="Unirse a la clase",LS="Paso {n} de 8",DS="Haga",NS="Observe",US="Piense",IS="Preparar",FS="Siguiente",OS="Anterior",kS=[["Ratón sobre el robot","arrastrar y mantener para empujar"],["Ratón sobre el suelo","arrastrar para cambiar la vista, rueda para acercarse"],["← → ↑ ↓","girar y conducir; la palanca izquierda de un mando hace lo mismo"],["F, B","empujar por delante, por detrás, mientras se mantenga la tecla"],["K","golpe"],["Espacio","pausa y continuar"],[".","un período"],[", y /","atrás y adelante en el tiempo, en pausa"],["S","poner de pie"],["1 … 8","abrir una pestaña"],["N, P","paso siguiente y anterior del recorrido; Intro lo prepara"],["[ ] { } + −","cambiar la vista y acercarse, con el foco en la sala"],["?","esta lista"]],BS=[{title:"Se cae solo",do:"No hay controlador. El robot empieza con una inclinación de 0,02 rad.",watch:"ψ crece como una exponencial, porque un polo en lazo abierto está en el semiplano derecho.",ask:"¿Cuánto tarda en duplicarse la inclinación? Compare con ln 2 entre el polo inestable (Ver, Ecuaciones)."},{title:"Linealizar",do:"Solo arrancan los dos modelos, sin controlador, desde una inclinación pequeña.",watch:"La traza no lineal y la lineal coinciden al principio y se separan hacia 0,5 rad.",ask:"¿Qué término de las ecuaciones aproxima el modelo lineal? Mire sen ψ."},{title:"Regular",do:"Ahora un LQR lo equilibra. Inclínelo y cambie la inclinación aceptada en Controlador.",watch:"Menor inclinación aceptada: mayor ganancia, regreso más rápido, más tensión.",ask:"¿Cómo cambian los márgenes con una inclinación aceptada menor? ¿Qué cuesta un regreso rápido?"},{title:"Empujar por delante",do:"Pulse Sostener por delante: una fuerza por delante mantiene ψ en 0,1 rad y luego cesa.",watch:"El robot se inclina contra la fuerza. Al soltarlo rueda, se pasa y vuelve.",ask:"¿Por qué un empujón por delante mantiene una inclinación hacia delante? Piense en la suma de momentos."},{title:"Empujar por detrás",do:"Pulse Sostener por detrás: −0,12 rad, y luego la fuerza cesa.",watch:"La misma respuesta, reflejada y algo mayor. φ apenas se mueve.",ask:"¿Es la respuesta exactamente la imagen reflejada? ¿Qué haría diferentes los dos lados?"},{title:"Comparar",do:"Empuje del mismo modo el gemelo y los modelos. Luego abra Identificar y pulse Comparar.",watch:"Las formas coinciden, los tiempos de establecimiento no: el modelo lineal se asienta de otro modo.",ask:"¿Cuál de las seis señales difiere más, y qué efecto físico hay detrás?"},{title:"Romper el modelo lineal",do:"El robot lleva una carga que ni el controlador ni el modelo lineal incluyen. Empuje más fuerte.",watch:"El fantasma lineal se mueve de otro modo; el gemelo oscila o cae.",ask:"¿Qué carga permite el margen? Busque el límite."},{title:"Hacerlo robusto",do:"Un diseño robusto tiene una ganancia para muchos robots. Repita sus empujones.",watch:"Se mantiene donde cayó el regulador anterior, quizá más despacio. La luz del certificado muestra el riesgo.",ask:"¿Qué costó la robustez? Compare esfuerzo y recorrido en un informe."}],zS="Este robot no se puede simular. El anterior está de nuevo aquí.",HS="Fue demasiado a la vez: una parte se omitió. Espere un momento.",VS="La simulación se detuvo y comenzó de nuevo. Todos los robots están de pie.",GS="Su último cambio detuvo la simulación para todos. Aquí está el robot habitual en su lugar.",WS={language:Nv,title:Uv,skip:Iv,connecting:Fv,connected:Ov,lost:kv,replaying:Bv,refused:zv,theme:Hv,help:Vv,close:Gv,scene:Wv,sceneNow:$v,fellNow:Xv,twin:qv,nonlinear:Yv,linear:Kv,published:jv,calibrated:Zv,twinNote:Jv,hint:Qv,fallen:ex,standUp:tx,tilt:nx,pause:ix,play:sx,step:rx,speed:ox,back:ax,now:lx,pushes:cx,front:ux,frontTip:hx,backPush:fx,backTip:dx,impulse:px,pullLeft:mx,pullRight:gx,size:_x,drive:vx,pitch:xx,pitch_rate:Mx,wheel:Sx,wheel_rate:yx,yaw:Ex,yaw_rate:bx,charts:wx,window:Tx,tabs:Ax,tabController:Rx,tabRobot:Cx,tabKit:Px,tabSee:Lx,tabIdentify:Dx,tabKeep:Nx,tabTour:Ux,tabClass:Ix,family:Fx,lqg:Ox,lqr:kx,"lqr-complementary":"LQR con filtro complementario","lqr-state":"LQR con el estado verdadero (solo simulado)",lqi:Bx,pid:zx,hinf:Hx,mpc:Vx,sliding:Gx,robust:Wx,gains:$x,off:Xx,weights:qx,command:Yx,ownWeights:Kx,noWeights:jx,designing:Zx,gain:Jx,gainBoth:Qx,margins:eM,gainMargin:tM,phaseMargin:nM,delayMargin:iM,unlimited:sM,certificate:rM,green:oM,amber:aM,red:lM,none:cM,noCertificate:uM,fullCertificate:hM,preset:fM,openRobot:dM,numbers:pM,numbersNote:mM,ownNumbers:gM,payload:_M,payloadHeight:vM,slope:xM,grip:MM,bodies:SM,kit:yM,ideal:EM,noise:bM,delay:wM,voltage:TM,deadZone:AM,ownKit:RM,loop:CM,bode:PM,nyquist:LM,poles:DM,portrait:NM,voltages:UM,voltagesNote:IM,torquesNote:FM,estimate:OM,estimateNote:kM,noEstimate:BM,equations:zM,equationsNote:HM,leftMotor:VM,rightMotor:GM,truth:WM,opinion:$M,saturated:XM,linearised:qM,openPoles:YM,source:KM,thisRun:jM,openLog:ZM,doctor:JM,doctorTip:QM,calibrate:eS,calibrateTip:tS,compare:nS,compareTip:iS,stop:sS,calibrateNote:rS,log:oS,keepNote:aS,csv:lS,parquet:cS,report:uS,replay:hS,controllerFile:fS,robotFile:dS,picture:pS,link:mS,linkCopied:gS,made:_S,recovered:vS,lostPush:xS,uploaded:MS,newtons:SS,board:yS,name:ES,bestPush:bS,effort:wS,broadcast:TS,yourName:AS,token:RS,enter:CS,joinTitle:PS,tourStep:LS,tourDo:DS,tourWatch:NS,tourAsk:US,tourSet:IS,next:FS,previous:OS,keys:kS,tour:BS,setBack:zS,tooMany:HS,restarted:VS,ended:GS},aa={en:Gc,es:WS};let Mr=Gc;function md(){return Object.keys(aa).find(i=>aa[i]===Mr)??"en"}function fh(i){Mr=aa[i]??Gc,document.documentElement.lang=md(),document.title=Mr.title}function gd(){return Mr}function q(i,e={}){return Mr[i].replace(/\{(\w+)\}/g,(t,n)=>String(e[n]??""))}function oi(i){const e=Mr[i];return typeof e=="string"?e:i}class zl{root;plot;constructor(e,t,n,s,r){const o=xr(),a=parseFloat(getComputedStyle(document.documentElement).fontSize)/16,l={stroke:o.soft,grid:{stroke:o.grid,width:1},ticks:{show:!1},font:`${11*a}px system-ui, sans-serif`},c=H("div",{className:"plot","aria-hidden":"true"});c.style.minHeight=`${s/16}rem`,this.root=H("figure",{className:"strip",role:"group","aria-label":`${e} [${t}]`},H("figcaption",{},H("b",{},e),H("span",{},t)),c),this.plot=new mn({width:300,height:s,padding:[6,8,0,0],cursor:{show:!1},legend:{show:!1},scales:{x:{time:!1},y:{range:(h,u,f)=>_d(u,f,r)}},axes:[{...l,size:20*a,values:(h,u)=>u.map(f=>f<0?"":`${+f.toFixed(1)} s`),space:70*a},{...l,size:46*a,space:24*a,values:(h,u)=>u.map(f=>String(+f.toPrecision(4)).replace("-","−"))}],series:[{},...n.map(h=>({label:h.label,stroke:h.colour,width:(h.width??1.6)*a,dash:h.dash,points:{show:!1},spanGaps:!1}))]},[[],...n.map(()=>[])],c),new ResizeObserver(()=>this.fit(c)).observe(c)}fit(e){e.clientWidth>40&&this.plot.setSize({width:e.clientWidth,height:e.clientHeight})}show(e,t,n,s){this.plot.batch(()=>{this.plot.setData([e,...t],!1),this.plot.setScale("x",{min:n,max:s})})}}function _d(i,e,t){if(!Number.isFinite(i)||!Number.isFinite(e))return[-t,t];const n=(i+e)/2,s=Math.max((e-i)/2*1.1,t);return[n-s,n+s]}const $S=[.05,.3,.5,1,.05,.2];class XS{constructor(e){this.seconds=e}root=H("section",{className:"charts","aria-label":q("charts")});strips=[];legend=H("div",{className:"legend"});build(){const e=te.changed?.bodies??[],t=e.map(n=>({label:oi(n),colour:Rs(n),dash:Vc(n)}));this.strips=ba.map((n,s)=>new zl(`${Cs[s]}  ${oi(n)}`,pd[s],t,104,$S[s])),St(this.legend,...e.map(n=>vd(n))),St(this.root,this.legend,H("div",{className:"strips"},...this.strips.map(n=>n.root)))}draw(){const{t:e,x:t}=te.traces;if(!e.length||t.length!==te.changed?.bodies.length)return;const n=te.snapshot?.back?te.snapshot.t:e.at(-1),s=n-this.seconds();let r=e.length;for(;r>0&&e[r-1]>=s;)r-=1;r=Math.max(0,r-1);const o=e.slice(r);this.strips.forEach((a,l)=>a.show(o,t.map(c=>c[l].slice(r)),s,n))}}function vd(i){const e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("width","28"),e.setAttribute("height","10"),e.setAttribute("aria-hidden","true");const t=document.createElementNS("http://www.w3.org/2000/svg","line"),n={x1:"0",x2:"28",y1:"5",y2:"5",stroke:Rs(i),"stroke-width":"2.5","stroke-dasharray":Vc(i).join(" ")};for(const[r,o]of Object.entries(n))t.setAttribute(r,o);e.append(t);const s=i==="twin"?q("twinNote"):"";return H("span",{className:"key",title:s},e,oi(i))}function qS(i){const e=Object.entries(i).filter(([s,r])=>JSON.stringify(r)!==JSON.stringify(Ea[s]));if(!e.length)return"";const t=JSON.stringify(Object.fromEntries(e)),n=Array.from(new TextEncoder().encode(t),s=>String.fromCharCode(s)).join("");return"#setup="+btoa(n).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"")}function YS(i){const e=/[#&]setup=([\w-]+)/.exec(i);if(!e)return null;try{const t=Uint8Array.from(atob(e[1].replaceAll("-","+").replaceAll("_","/")),s=>s.charCodeAt(0)),n=JSON.parse(new TextDecoder().decode(t));return{...Ea,...n}}catch{return null}}function KS(i){return/[#&]token=([\w-]+)/.exec(i)?.[1]??""}let jS=class{constructor(e,t){this.credentials=e,this.say=t,te.send=n=>this.send(n),this.open()}socket=null;wait=250;closed=!1;first=!0;send(e){this.socket?.readyState===WebSocket.OPEN&&this.socket.send(JSON.stringify(e))}open(){this.say(this.first?"connecting":"lost");const e=new URL("ws",document.baseURI);e.protocol=e.protocol.replace("http","ws"),e.hash="";const t=new WebSocket(e);this.socket=t,t.onopen=()=>this.greet(),t.onmessage=n=>this.hear(JSON.parse(n.data)),t.onclose=()=>this.lost()}greet(){const e=this.first?YS(location.hash):null;this.send({kind:"Hello",version:xg,session:e?"":sessionStorage.getItem("session")??"",token:this.credentials.token,name:this.credentials.name,setup:e??(te.changed?te.setup:null)})}hear(e){e.kind==="Snapshot"&&this.send({kind:"Ack",n:e.n}),e.kind==="Welcome"&&(sessionStorage.setItem("session",e.session),this.wait=250,this.first=!1,this.say("connected")),e.kind==="Refused"&&(this.closed=!0,this.say("refused",e.reason)),te.hear(e)}lost(){this.closed||(this.say("lost"),window.setTimeout(()=>this.open(),this.wait),this.wait=Math.min(this.wait*1.6,3e3))}};const ZS="http://www.w3.org/2000/svg",Hr=420,$t={left:58,right:10,top:8,bottom:34};function no(i){const e=i.square?Hr*.82:190,t=Gn("svg",{viewBox:`0 0 ${Hr} ${e}`,role:"img","aria-label":i.title,class:"drawing"}),n=v=>i.logX?Math.log10(v):v,[s,r]=[n(i.x[0]),n(i.x[1])],[o,a]=[Hr-$t.left-$t.right,e-$t.top-$t.bottom],l=v=>$t.left+(n(v)-s)/(r-s)*o,c=v=>$t.top+(1-(v-i.y[0])/(i.y[1]-i.y[0]))*a,h=xr(),u=`clip-${Math.random().toString(36).slice(2)}`,f=Gn("clipPath",{id:u});f.append(Gn("rect",{x:$t.left,y:$t.top,width:o,height:a})),t.append(f);for(const v of i.logX?ey(i.x):dh(i.x,6))t.append(Gn("line",{x1:l(v),x2:l(v),y1:$t.top,y2:$t.top+a,stroke:h.grid})),t.append(bo(ph(v),l(v),$t.top+a+14,"middle",h.soft));for(const v of dh(i.y,5))t.append(Gn("line",{x1:$t.left,x2:Hr-$t.right,y1:c(v),y2:c(v),stroke:h.grid})),t.append(bo(ph(v),$t.left-6,c(v)+4,"end",h.soft));t.append(bo(i.xLabel,$t.left+o/2,e-4,"middle",h.soft));const g=bo(i.yLabel,0,0,"middle",h.soft);g.setAttribute("transform",`translate(9 ${$t.top+a/2}) rotate(-90)`),t.append(g);const _=Gn("g",{"clip-path":`url(#${u})`});t.append(_),i.circle&&_.append(Gn("ellipse",{cx:l(0),cy:c(0),rx:l(1)-l(0),ry:c(0)-c(1),fill:"none",stroke:h.soft,"stroke-dasharray":"4 3"}));for(const v of i.marks??[]){const p=v.y===void 0?{x1:l(v.x??0),x2:l(v.x??0),y1:$t.top,y2:$t.top+a}:{y1:c(v.y),y2:c(v.y),x1:$t.left,x2:Hr-$t.right};_.append(Gn("line",{...p,stroke:h.push,"stroke-width":1.2,"stroke-dasharray":"5 3"}))}for(const v of i.lines??[])_.append(JS(v,l,c));for(const v of i.points??[])_.append(QS(v.cross??!1,l(v.x),c(v.y),v.colour));return t}function Gn(i,e={}){const t=document.createElementNS(ZS,i);for(const[n,s]of Object.entries(e))t.setAttribute(n,String(s));return t}function bo(i,e,t,n,s){const r=Gn("text",{x:e,y:t,"text-anchor":n,fill:s,"font-size":11.5});return r.textContent=i,r}function JS(i,e,t){let n="",s=!1;return i.x.forEach((r,o)=>{const a=i.y[o],l=Number.isFinite(r)&&Number.isFinite(a);l&&(n+=`${s?"L":"M"}${e(r).toFixed(1)} ${t(a).toFixed(1)}`),s=l}),Gn("path",{d:n,fill:"none",stroke:i.colour,"stroke-width":1.8,"stroke-dasharray":(i.dash??[]).join(" "),"stroke-linejoin":"round"})}function QS(i,e,t,n){if(!i)return Gn("circle",{cx:e,cy:t,r:4,fill:n});const s=4.5;return Gn("path",{d:`M${e-s} ${t-s}L${e+s} ${t+s}M${e-s} ${t+s}L${e+s} ${t-s}`,stroke:n,"stroke-width":1.8})}function dh([i,e],t){const n=(e-i)/t,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].map(a=>a*s).find(a=>a>=n)??n,o=[];for(let a=Math.ceil(i/r)*r;a<=e+r*1e-6;a+=r)o.push(Math.abs(a)<r*1e-6?0:a);return o}function ey([i,e]){const t=[];for(let n=Math.ceil(Math.log10(i));10**n<=e;n+=1)t.push(10**n);return t}function ph(i){return String(+i.toPrecision(6)).replace("-","−")}const ty=["loop","portrait","voltages","estimate","equations"],wo=8,ny=["ψ̇","ψ̈","θ̇","θ̈","φ̇","φ̈"];class iy{root=H("div",{className:"see"});view="loop";stage=H("div",{className:"stage"});strips=[];build(){const e=ty.map(n=>[n,q(n)]),t=Ls(q("tabSee"),e,this.view,n=>{this.view=n,this.show()},"view");St(this.root,t,this.stage),this.show()}show(){this.strips=[],this.view==="loop"?St(this.stage,...this.loop()):this.view==="equations"?St(this.stage,...ay()):this.view==="voltages"?this.voltages():this.view==="estimate"?this.estimate():this.portrait()}draw(){if(this.view==="portrait"&&this.portrait(),!this.strips.length)return;const e=te.traces,t=e.t.at(-1)??0;let n=e.t.length;for(;n>0&&e.t[n-1]>=t-wo;)n-=1;const s=e.t.slice(n),r=o=>o.slice(n);if(this.view==="estimate")this.strips[0].show(s,[r(e.x[0]?.[0]??[]),r(e.estimate)],t-wo,t);else{const o=[1,2].map((a,l)=>r(e.saturated).map((c,h)=>c&a?e.volts[l][n+h]:NaN));this.strips.forEach((a,l)=>a.show(s,[r(e.volts[l]),o[l]],t-wo,t))}}voltages(){const{text:e,push:t}=xr(),n=te.changed?.look.command_unit??"V";this.strips=[q("leftMotor"),q("rightMotor")].map(r=>new zl(r,n,[{label:r,colour:e,dash:[]},{label:q("saturated"),colour:t,dash:[],width:5}],150,1));const s=H("p",{className:"note"},q(n==="V"?"voltagesNote":"torquesNote"));St(this.stage,s,...this.strips.map(r=>r.root))}estimate(){if(!te.snapshot?.e.length){St(this.stage,H("p",{className:"note"},q("noEstimate")));return}const{push:e}=xr(),t=[{label:q("truth"),colour:Rs(te.changed?.bodies[0]??"twin"),dash:[]},{label:q("opinion"),colour:e,dash:[4,3]}];this.strips=[new zl(`ψ: ${q("truth")} / ${q("opinion")}`,"rad",t,190,.02)],St(this.stage,H("p",{className:"note"},q("estimateNote")),this.strips[0].root)}portrait(){const{t:e,x:t}=te.traces,n=(e.at(-1)??0)-wo;let s=e.length;for(;s>0&&e[s-1]>=n;)s-=1;const r=(o,a)=>{const l=t.map((f,g)=>{const _=te.changed?.bodies[g]??"";return{x:f[o].slice(s),y:f[o+1].slice(s),colour:Rs(_),dash:Vc(_)}}),c=(f,g)=>{const _=l.flatMap(d=>d[f]),[v,p]=[_.reduce((d,w)=>Math.min(d,w),1/0),_.reduce((d,w)=>Math.max(d,w),-1/0)];return _d(v,p,g)},h=l.map(f=>({x:f.x.at(-1)??0,y:f.y.at(-1)??0,colour:f.colour})),u=oi(ba[o]);return la(u,no({title:`${q("portrait")}: ${u}`,xLabel:`${Cs[o]} [rad]`,yLabel:`${Cs[o+1]} [rad/s]`,lines:l,points:h,x:c("x",a[0]),y:c("y",a[1]),square:!0}))};St(this.stage,r(0,[.03,.4]),r(2,[.5,1]),r(4,[.05,.2]))}loop(){const e=te.analysed;if(!e)return[H("p",{className:"note"},q("designing"))];const t=H("p",{className:"note"},Wc(e.words)),n=Rs("twin"),s=[t];return e.L.length===3&&s.push(...sy(e.L,n)),e.poles.length&&s.push(ry(e.poles,n)),s}}function sy([i,e,t],n){const s=i.map((u,f)=>20*Math.log10(Math.hypot(e[f],t[f]))),r=oy(i.map((u,f)=>Math.atan2(t[f],e[f])*180/Math.PI)),o=[i[0],i.at(-1)],a=(u,f)=>[Math.min(...u)-f,Math.max(...u)+f],l=[no({title:q("bode"),xLabel:"ω [rad/s]",yLabel:"|L| [dB]",lines:[{x:i,y:s,colour:n}],x:o,y:a(s,3),logX:!0,marks:[{y:0}]}),no({title:q("bode"),xLabel:"ω [rad/s]",yLabel:"∠L [°]",lines:[{x:i,y:r,colour:n}],x:o,y:a(r,8),logX:!0,marks:[{y:-180}]})],c=t.map(u=>-u),h=no({title:q("nyquist"),xLabel:"Re L",yLabel:"Im L",square:!0,x:[-3.2,1.6],y:[-2,2],circle:!0,lines:[{x:e,y:t,colour:n},{x:e,y:c,colour:n,dash:[4,3]}],points:[{x:-1,y:0,colour:xr().push,cross:!0}]});return[la(q("bode"),...l),la(q("nyquist"),h)]}function ry(i,e){const t=i.map(([r,o])=>({x:r,y:o,colour:Math.hypot(r,o)>=1?xr().push:e,cross:!0})),n=Math.max(1.15,...i.map(([r,o])=>Math.max(Math.abs(r),Math.abs(o))*1.1)),s=n*1.2;return la(q("poles"),no({title:q("poles"),xLabel:"Re z",yLabel:"Im z",points:t,x:[-s,s],y:[-n,n],square:!0,circle:!0}))}function Wc(i){return i.charAt(0).toUpperCase()+i.slice(1)}function la(i,...e){return H("figure",{className:"titled","aria-label":i},H("figcaption",{},i),...e)}function oy(i){let e=0;return i.map((t,n)=>(n&&(e+=Math.round((i[n-1]-t)/360)*360),t+e)).map((t,n,s)=>t-Math.round((s[0]+180)/360)*360)}function ay(){const i=te.equations;if(!i)return[];const[e,,t,n]=i.inertias.map(p=>zt(p,4)),[s,r,o,a]=[i.alpha,i.beta,i.weight,i.lever].map(p=>zt(p,4)),[l,c]=[zt(i.swing,4),zt(i.half_track,4)],h=`(${a} cos ψ − ${zt(i.lever-i.inertias[1],3)})`,[u,f]=[`${s} (v_l + v_r)`,`2·${r} (θ̇ − ψ̇)`],g=[`${e} θ̈ + ${h} ψ̈ = ${u} − ${f} + ${a} (ψ̇² + φ̇²) sin ψ`,`${h} θ̈ + ${t} ψ̈ = −${u} + ${f} + (${o} + ${l} φ̇² cos ψ) sin ψ`,`(${n} + ${l} sin² ψ) φ̈ = ${c}·${s} (v_r − v_l) − 2·${c}²·${r} φ̇ − (2·${l} ψ̇ cos ψ + ${a} θ̇) φ̇ sin ψ`,`α = ${s}   β = ${r}   M g L = ${o} N m   M L R = ${a} kg m²   W/2R = ${c}`],_=(p,d)=>oa([p,...d[0].map((w,T)=>p==="A"?Cs[T]:["v_l","v_r"][T])],d.map((w,T)=>[ny[T],...w.map(y=>zt(y,4))]),"matrix"),v=i.poles.map(([p,d])=>zt(p,4)+(d?` ± ${zt(Math.abs(d),3)}j`:"")).join(",  ");return[H("pre",{className:"equations",tabIndex:0},g.join(`
`)),H("p",{className:"note"},q("equationsNote")),H("p",{},`${q("openPoles")}: ${v} 1/s`),H("h4",{},q("linearised")),_("A",i.A),_("B",i.B)]}const ly=dd(120,i=>te.change(i));let Ya={};function gi(i){Ya={...Ya,...i},te.setup={...te.setup,...i},ly(Ya)}class ao{root=H("div",{className:"panel-body"});update(){}}class cy extends ao{weights=H("div",{className:"sliders"});numbers=H("div",{className:"numbers"});light=H("div",{className:"light",role:"status"});sliders=[];shape="";build(){this.shape="";const e=(te.catalogue?.families??[]).map(s=>[s.name,oi(s.name)]),t=Ls(q("family"),e,te.setup.controller,s=>{te.change({controller:s,gains:s==="gains"&&!te.setup.gains.length?this.present():te.setup.gains})},"controller"),n=bt(q("fullCertificate"),()=>te.send({kind:"Start",job:"certify",file:""}),{"data-key":"certify"});St(this.root,H("div",{className:"column"},t,this.weights),H("div",{className:"column"},this.numbers),H("div",{className:"column"},this.light,n)),this.update()}present(){return te.analysed?.gain[0]?.slice(0,6)??[0,0,0,0,0,0]}update(){const e=this.root.querySelector("[data-key=controller]");e&&document.activeElement!==e&&(e.value=te.setup.controller);const t=`${te.setup.controller} ${te.changed?.look.command_unit}`;t!==this.shape&&this.shapeWeights(t),this.sliders.forEach((n,s)=>n.set(te.setup.controller==="gains"?te.setup.gains[s]??0:this.sizes()[s])),St(this.numbers,...this.analysis()),St(this.light,...xd())}sizes(){const e=te.changed?.look.command_unit??"V",t=[...te.catalogue?.largest??[],te.catalogue?.command[e]??1];return te.setup.largest.length===t.length?te.setup.largest:t}shapeWeights(e){this.shape=e;const t=te.catalogue?.families.find(n=>n.name===te.setup.controller);if(this.sliders=[],te.setup.controller==="gains")this.sliders=Cs.map((n,s)=>ii(`${n} → u`,{low:-150,high:150,step:.05,show:r=>zt(r,4),key:`gain-${s}`},r=>{const o=[...te.setup.gains.length?te.setup.gains:[0,0,0,0,0,0]];o[s]=r,gi({gains:o})})),St(this.weights,...this.sliders.map(n=>n.root));else if(t?.weights){const n=[...te.catalogue?.largest??[],te.catalogue?.command[te.changed?.look.command_unit??"V"]??1];this.sliders=n.map((r,o)=>this.weight(r,o));const s=bt(q("ownWeights"),()=>te.change({largest:[]}),{className:"quiet","data-key":"own-weights"});St(this.weights,H("p",{className:"note"},q("weights")),...this.sliders.map(r=>r.root),s)}else St(this.weights,H("p",{className:"note"},q("noWeights")))}weight(e,t){const n=t<6?pd[t]:te.changed?.look.command_unit??"V",s=t<6?`${Cs[t]} ${oi(ba[t])}`:q("command");return ii(s,{low:e/10,high:e*10,log:!0,show:r=>`${zt(r,2)} ${n}`,key:`weight-${t}`},r=>{const o=[...this.sizes()];o[t]=r,gi({largest:o})})}analysis(){const e=te.analysed;if(!e)return[H("p",{className:"note"},te.setup.controller==="off"?q("off"):q("designing"))];const t=[];e.gain.length&&t.push(H("h4",{},q("gain")),oa(Cs,[e.gain[0].map(r=>zt(r,3))],"gains"));const n=(r,o)=>`${r===null?"0":zt(r,2)} … ${o===null?"∞":zt(o,3)}`,s=[[q("gainMargin"),n(e.gain_low,e.gain_high)],[q("phaseMargin"),e.phase===null?q("unlimited"):`${zt(e.phase*180/Math.PI,2)}°`],[q("delayMargin"),e.delay===null?q("unlimited"):`${zt(e.delay*1e3,3)} ms`]];return e.stable&&t.push(H("h4",{},q("margins")),oa([],s,"margins")),t.push(H("p",{className:"note"},Wc(e.words))),t}}function xd(){const i=te.lit,e=i?.light??"none",t=e==="none"&&i?.reasons.length?q("noCertificate"):q(e),n=H("span",{className:`lamp ${e}`,"aria-hidden":"true"});return[H("h4",{},q("certificate")),H("p",{className:"lit"},n,H("b",{},t)),...(i?.reasons??[]).map(s=>H("p",{className:"note"},Wc(s)))]}class uy extends ao{sliders=[];table=H("div",{className:"parameters"});shown="";opened=!1;build(){this.shown="";const e=(te.catalogue?.robots??[]).map(s=>[s.name,s.name]);e.some(([s])=>s===te.setup.robot)||e.push([te.setup.robot,te.setup.robot]);const t=Ls(q("preset"),e,te.setup.robot,s=>this.choose(s),"robot");this.sliders=[["payload",ii(q("payload"),{low:0,high:this.weight(),step:.005,show:s=>`${zt(s*1e3,3)} g`,key:"payload"},s=>gi({payload:s}))],["payload_height",ii(q("payloadHeight"),{low:0,high:.5,step:.005,show:s=>`${zt(s*100,3)} cm`,key:"payload_height"},s=>gi({payload_height:s}))],["slope",ii(q("slope"),{low:-.2,high:.2,step:.005,show:s=>`${zt(s,2)} rad`,key:"slope"},s=>gi({slope:s}))],["grip",ii(q("grip"),{low:.02,high:10,log:!0,show:s=>zt(s,2),key:"grip"},s=>gi({grip:s}))]];const n=H("details",{open:this.opened,ontoggle:()=>this.opened=n.open},H("summary",{},q("numbers")),H("p",{className:"note"},q("numbersNote")),this.table);St(this.root,H("div",{className:"column"},t,H("p",{className:"note"},this.title()),Md(q("openRobot"),".toml","robot")),H("div",{className:"column"},H("div",{className:"sliders"},...this.sliders.map(([,s])=>s.root))),H("div",{className:"column"},this.bodies()),H("div",{className:"column full"},n)),this.update()}weight(){return Math.max(.3,(te.changed?.look.weight??6)/9.81*.6)}title(){return te.catalogue?.robots.find(e=>e.name===te.setup.robot)?.title??""}choose(e){const t=te.catalogue?.robots.find(n=>n.name===e);t&&te.change({robot:e,numbers:{},drive:"",kit:t.kit,largest:[],gains:[],payload:0,delay:-1,voltage:-1,dead_zone:-1})}bodies(){const e=["twin","nonlinear","linear","published",...te.changed?.bodies.includes("calibrated")?["calibrated"]:[]],t=e.map(n=>{const s=so("body"),r=H("input",{type:"checkbox",id:s,checked:te.setup.bodies.includes(n),"data-key":`body-${n}`,onchange:()=>{const o=e.filter(a=>a===n?r.checked:te.setup.bodies.includes(a));o.length?te.change({bodies:o}):r.checked=!0}});return H("label",{for:s,className:"check"},r,vd(n))});return H("fieldset",{},H("legend",{},q("bodies")),...t)}update(){for(const[n,s]of this.sliders)s.set(te.setup[n]);const e=JSON.stringify([te.setup.robot,te.setup.numbers,te.changed?.bodies]);if(e===this.shown)return;const t=this.shown!=="";this.shown=e,t&&!this.root.contains(document.activeElement)&&this.build(),this.parameters()}parameters(){const t={...te.catalogue?.robots.find(s=>s.name===te.setup.robot)?.numbers??{},...te.setup.numbers},n=Object.entries(t).map(([s,r])=>{const o=so("number"),a=H("input",{type:"number",id:o,step:"any",value:String(r),"data-key":`number-${s}`,onchange:()=>{Number.isFinite(a.valueAsNumber)&&te.change({numbers:{...te.setup.numbers,[s]:a.valueAsNumber}})}}),l=te.catalogue?.symbols[s]??"";return H("div",{className:"parameter"},H("label",{for:o},`${s.replaceAll("_"," ")} ${l}`),a,H("span",{},(te.catalogue?.units[s]??"").replace(/^1$/,"")))});St(this.table,...n,bt(q("ownNumbers"),()=>te.change({numbers:{},drive:""}),{className:"quiet","data-key":"own-numbers"}))}}class hy extends ao{sliders=[];build(){const e=(te.catalogue?.kits??[]).map(r=>[r,r==="ideal"?q("ideal"):r]),t=Ls(q("kit"),e,te.setup.kit,r=>te.change({kit:r,delay:-1,voltage:-1,dead_zone:-1,noise:1}),"kit"),n=te.changed?.look.command_unit??"V";this.sliders=[["noise",ii(q("noise"),{low:0,high:10,step:.1,show:r=>`× ${zt(r,2)}`,key:"noise"},r=>gi({noise:r}))],["delay",ii(q("delay"),{low:0,high:.04,step:.002,show:r=>`${zt(r*1e3,2)} ms`,key:"delay"},r=>gi({delay:r}))],["voltage",ii(q("voltage"),{low:1,high:14,step:.1,show:r=>r>0?`${zt(r,3)} V`:q("unlimited"),key:"voltage"},r=>gi({voltage:r}))],["dead_zone",ii(q("deadZone"),{low:0,high:n==="V"?2:.1,show:r=>`${zt(r,2)} ${n}`,key:"dead_zone"},r=>gi({dead_zone:r}))]];const s=bt(q("ownKit"),()=>te.change({noise:1,delay:-1,voltage:-1,dead_zone:-1}),{className:"quiet","data-key":"own-kit"});St(this.root,H("div",{className:"column"},t,s),H("div",{className:"column wide"},H("div",{className:"sliders"},...this.sliders.map(([,r])=>r.root)))),this.update()}update(){const e=te.changed?.kit??{};for(const[n,s]of this.sliders)s.set(n==="noise"?te.setup.noise:e[n]);const t=this.root.querySelector("[data-key=kit]");t&&document.activeElement!==t&&(t.value=te.setup.kit)}}function Md(i,e,t){const n=so("file"),s=H("input",{type:"file",id:n,accept:e,className:"file","data-key":`open-${t}`,onchange:()=>{const r=s.files?.[0];s.value="",r&&fy(r,t)}});return H("div",{className:"upload"},s,H("label",{for:n,className:"button"},i))}let ys="";async function fy(i,e){const t=`upload/${te.session}?what=${e}&name=${encodeURIComponent(i.name)}`;te.hear({kind:"Notice",level:"info",text:q("uploaded",{name:i.name}),key:""});try{const s=await(await fetch(t,{method:"POST",body:i})).json();s.error?te.hear({kind:"Notice",level:"error",text:s.error,key:""}):e==="log"&&(ys=s.name??"")}catch{te.hear({kind:"Notice",level:"error",text:q("lost"),key:""})}}class dy extends ao{bars=H("div",{className:"bars"});result=H("div",{className:"result",role:"region","aria-live":"polite"});shares=new Map;source="";build(){const e=[["",q("thisRun")]];ys&&e.push([ys,ys.replace(/^in-/,"")]),ys&&(this.source=ys);const t=Ls(q("source"),e,this.source,o=>this.source=o,"source"),n=o=>te.send({kind:"Start",job:o,file:this.source}),s=H("div",{className:"row"},bt(q("doctor"),()=>n("doctor"),{title:q("doctorTip"),"data-key":"doctor"}),bt(q("calibrate"),()=>n("calibrate"),{title:q("calibrateTip"),"data-key":"calibrate"}),bt(q("compare"),()=>te.send({kind:"Save",what:"report"}),{title:q("compareTip"),"data-key":"compare"}));St(this.root,H("div",{className:"column"},t,Md(q("openLog"),".csv,.txt,.log,.tsv,.dat,.json,.mat,.parquet,.mcap","log"),s,H("p",{className:"note"},q("calibrateNote")),this.bars),H("div",{className:"column wide"},this.result)),this.found()}progress(e,t){t>=1?this.shares.delete(e):this.shares.set(e,t);const n=[...this.shares].filter(([s])=>s!=="design").map(([s,r])=>H("div",{className:"bar"},H("span",{},oi(s)),H("progress",{max:1,value:r,"aria-label":oi(s)}),bt(q("stop"),()=>te.send({kind:"Cancel",job:s}),{"data-key":`stop-${s}`})));St(this.bars,...n)}found(){const e=te.found;if(!e)return;const t=e.text.split(`
`).map(n=>H("p",{className:"note"},n));St(this.result,H("h4",{},e.title),...t,e.rows.length?oa(e.header,e.rows):null)}}class py extends ao{constructor(e){super(),this.picture=e}links=H("div",{className:"links",role:"status"});build(){const t=[["csv",q("csv")],["parquet",q("parquet")],["report",q("report")],["replay",q("replay")],["controller",q("controllerFile")],["robot",q("robotFile")]].map(([r,o])=>bt(o,()=>te.send({kind:"Save",what:r}),{"data-key":`keep-${r}`})),n=bt(q("picture"),()=>void this.photograph(),{"data-key":"picture"}),s=bt(q("link"),()=>void this.copy(),{"data-key":"link"});St(this.root,H("div",{className:"column wide"},H("p",{className:"note"},q("keepNote")),H("div",{className:"row"},...t,n,s),this.links))}async photograph(){const e=await this.picture();e&&this.made(e.type.includes("svg")?"upright.svg":"upright.png",URL.createObjectURL(e))}async copy(){const e=location.href.split("#")[0]+qS(te.setup);history.replaceState(null,"",e),await navigator.clipboard?.writeText(e).catch(()=>{});const t=H("input",{readOnly:!0,value:e,"aria-label":q("link"),className:"address"});this.links.prepend(H("p",{className:"note"},q("linkCopied"),t)),t.select()}made(e,t){const n=H("a",{href:t,download:e},q("made",{name:e}));this.links.prepend(H("p",{},n)),n.click()}}class mh{moments;at=0;paused=!1;speed=1;clock=performance.now();constructor(e){this.moments=e.filter(t=>t.kind==="Snapshot"),te.replaying=!0,te.send=t=>this.act(t);for(const t of e)t.kind!=="Snapshot"&&te.hear(t);window.setInterval(()=>this.tick(),20)}static inPage(){const e=document.getElementById("recording");return e?JSON.parse(e.textContent??"[]"):null}tick(){const e=performance.now();!this.paused&&this.moments.length&&(this.at+=(e-this.clock)/1e3*this.speed,this.at>this.length()&&this.rewind(),this.show()),this.clock=e}length(){return(this.moments.at(-1)?.t??0)-(this.moments[0]?.t??0)}rewind(){this.at=0,te.traces.reset(this.moments[0].x.length)}show(){const e=this.moments[0].t+this.at,t=te.traces.t.at(-1)??-1/0;e<t&&te.traces.until(e);const n=this.moments.filter(r=>r.t>t&&r.t<=e),s=n.at(-1)??this.moments.findLast(r=>r.t<=e);for(const r of n.slice(0,-1))te.traces.add(r);s&&te.hear({...s,paused:this.paused,back:0})}act(e){if(e.kind==="Play")this.paused=e.paused,this.speed=e.speed;else if(e.kind==="Scrub")this.paused=!0,this.at=Math.max(0,this.length()-e.back);else if(e.kind==="Step")this.paused=!0,this.at+=.02*e.periods;else if(e.kind==="StandUp")this.rewind();else return;this.show()}}/**
 * @license
 * Copyright 2010-2024 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const $c="170",my=0,gh=1,gy=2,Sd=1,yd=2,Pi=3,is=0,An=1,Li=2,es=0,fr=1,_h=2,vh=3,xh=4,_y=5,Es=100,vy=101,xy=102,My=103,Sy=104,yy=200,Ey=201,by=202,wy=203,Hl=204,Vl=205,Ty=206,Ay=207,Ry=208,Cy=209,Py=210,Ly=211,Dy=212,Ny=213,Uy=214,Gl=0,Wl=1,$l=2,Sr=3,Xl=4,ql=5,Yl=6,Kl=7,Ed=0,Iy=1,Fy=2,ts=0,Oy=1,ky=2,By=3,zy=4,Hy=5,Vy=6,Gy=7,bd=300,yr=301,Er=302,jl=303,Zl=304,wa=306,ca=1e3,ws=1001,Jl=1002,ri=1003,Wy=1004,To=1005,_i=1006,Ka=1007,Ts=1008,Oi=1009,wd=1010,Td=1011,ro=1012,Xc=1013,Ds=1014,Di=1015,lo=1016,qc=1017,Yc=1018,br=1020,Ad=35902,Rd=1021,Cd=1022,si=1023,Pd=1024,Ld=1025,dr=1026,wr=1027,Dd=1028,Kc=1029,Nd=1030,jc=1031,Zc=1033,Zo=33776,Jo=33777,Qo=33778,ea=33779,Ql=35840,ec=35841,tc=35842,nc=35843,ic=36196,sc=37492,rc=37496,oc=37808,ac=37809,lc=37810,cc=37811,uc=37812,hc=37813,fc=37814,dc=37815,pc=37816,mc=37817,gc=37818,_c=37819,vc=37820,xc=37821,ta=36492,Mc=36494,Sc=36495,Ud=36283,yc=36284,Ec=36285,bc=36286,$y=3200,Xy=3201,Id=0,qy=1,Ji="",In="srgb",Pr="srgb-linear",Ta="linear",At="srgb",Ys=7680,Mh=519,Yy=512,Ky=513,jy=514,Fd=515,Zy=516,Jy=517,Qy=518,eE=519,Sh=35044,yh="300 es",Ni=2e3,ua=2001;class Lr{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});const n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){if(this._listeners===void 0)return!1;const n=this._listeners;return n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){if(this._listeners===void 0)return;const s=this._listeners[e];if(s!==void 0){const r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){if(this._listeners===void 0)return;const n=this._listeners[e.type];if(n!==void 0){e.target=this;const s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}}const fn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],ja=Math.PI/180,wc=180/Math.PI;function co(){const i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(fn[i&255]+fn[i>>8&255]+fn[i>>16&255]+fn[i>>24&255]+"-"+fn[e&255]+fn[e>>8&255]+"-"+fn[e>>16&15|64]+fn[e>>24&255]+"-"+fn[t&63|128]+fn[t>>8&255]+"-"+fn[t>>16&255]+fn[t>>24&255]+fn[n&255]+fn[n>>8&255]+fn[n>>16&255]+fn[n>>24&255]).toLowerCase()}function Tn(i,e,t){return Math.max(e,Math.min(t,i))}function tE(i,e){return(i%e+e)%e}function Za(i,e,t){return(1-t)*i+t*e}function Vr(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function wn(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}class mt{constructor(e=0,t=0){mt.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){const t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Math.max(e.x,Math.min(t.x,this.x)),this.y=Math.max(e.y,Math.min(t.y,this.y)),this}clampScalar(e,t){return this.x=Math.max(e,Math.min(t,this.x)),this.y=Math.max(e,Math.min(t,this.y)),this}clampLength(e,t){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(e,Math.min(t,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const n=this.dot(e)/t;return Math.acos(Tn(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){const n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class et{constructor(e,t,n,s,r,o,a,l,c){et.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){const h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){const t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){const t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],f=n[2],g=n[5],_=n[8],v=s[0],p=s[3],d=s[6],w=s[1],T=s[4],y=s[7],z=s[2],L=s[5],D=s[8];return r[0]=o*v+a*w+l*z,r[3]=o*p+a*T+l*L,r[6]=o*d+a*y+l*D,r[1]=c*v+h*w+u*z,r[4]=c*p+h*T+u*L,r[7]=c*d+h*y+u*D,r[2]=f*v+g*w+_*z,r[5]=f*p+g*T+_*L,r[8]=f*d+g*y+_*D,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){const e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){const e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,f=a*l-h*r,g=c*r-o*l,_=t*u+n*f+s*g;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);const v=1/_;return e[0]=u*v,e[1]=(s*c-h*n)*v,e[2]=(a*n-s*o)*v,e[3]=f*v,e[4]=(h*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=g*v,e[7]=(n*l-c*t)*v,e[8]=(o*t-n*r)*v,this}transpose(){let e;const t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){const t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(Ja.makeScale(e,t)),this}rotate(e){return this.premultiply(Ja.makeRotation(-e)),this}translate(e,t){return this.premultiply(Ja.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){const t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){const t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){const n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}}const Ja=new et;function Od(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function ha(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function nE(){const i=ha("canvas");return i.style.display="block",i}const Eh={};function Jr(i){i in Eh||(Eh[i]=!0,console.warn(i))}function iE(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}function sE(i){const e=i.elements;e[2]=.5*e[2]+.5*e[3],e[6]=.5*e[6]+.5*e[7],e[10]=.5*e[10]+.5*e[11],e[14]=.5*e[14]+.5*e[15]}function rE(i){const e=i.elements;e[11]===-1?(e[10]=-e[10]-1,e[14]=-e[14]):(e[10]=-e[10],e[14]=-e[14]+1)}const pt={enabled:!0,workingColorSpace:Pr,spaces:{},convert:function(i,e,t){return this.enabled===!1||e===t||!e||!t||(this.spaces[e].transfer===At&&(i.r=Fi(i.r),i.g=Fi(i.g),i.b=Fi(i.b)),this.spaces[e].primaries!==this.spaces[t].primaries&&(i.applyMatrix3(this.spaces[e].toXYZ),i.applyMatrix3(this.spaces[t].fromXYZ)),this.spaces[t].transfer===At&&(i.r=pr(i.r),i.g=pr(i.g),i.b=pr(i.b))),i},fromWorkingColorSpace:function(i,e){return this.convert(i,this.workingColorSpace,e)},toWorkingColorSpace:function(i,e){return this.convert(i,e,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===Ji?Ta:this.spaces[i].transfer},getLuminanceCoefficients:function(i,e=this.workingColorSpace){return i.fromArray(this.spaces[e].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,e,t){return i.copy(this.spaces[e].toXYZ).multiply(this.spaces[t].fromXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}};function Fi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function pr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}const bh=[.64,.33,.3,.6,.15,.06],wh=[.2126,.7152,.0722],Th=[.3127,.329],Ah=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Rh=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);pt.define({[Pr]:{primaries:bh,whitePoint:Th,transfer:Ta,toXYZ:Ah,fromXYZ:Rh,luminanceCoefficients:wh,workingColorSpaceConfig:{unpackColorSpace:In},outputColorSpaceConfig:{drawingBufferColorSpace:In}},[In]:{primaries:bh,whitePoint:Th,transfer:At,toXYZ:Ah,fromXYZ:Rh,luminanceCoefficients:wh,outputColorSpaceConfig:{drawingBufferColorSpace:In}}});let Ks;class oE{static getDataURL(e){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let t;if(e instanceof HTMLCanvasElement)t=e;else{Ks===void 0&&(Ks=ha("canvas")),Ks.width=e.width,Ks.height=e.height;const n=Ks.getContext("2d");e instanceof ImageData?n.putImageData(e,0,0):n.drawImage(e,0,0,e.width,e.height),t=Ks}return t.width>2048||t.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",e),t.toDataURL("image/jpeg",.6)):t.toDataURL("image/png")}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){const t=ha("canvas");t.width=e.width,t.height=e.height;const n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);const s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Fi(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){const t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Fi(t[n]/255)*255):t[n]=Fi(t[n]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}}let aE=0;class kd{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:aE++}),this.uuid=co(),this.data=e,this.dataReady=!0,this.version=0}set needsUpdate(e){e===!0&&this.version++}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];const n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Qa(s[o].image)):r.push(Qa(s[o]))}else r=Qa(s);n.url=r}return t||(e.images[this.uuid]=n),n}}function Qa(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?oE.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let lE=0;class yn extends Lr{constructor(e=yn.DEFAULT_IMAGE,t=yn.DEFAULT_MAPPING,n=ws,s=ws,r=_i,o=Ts,a=si,l=Oi,c=yn.DEFAULT_ANISOTROPY,h=Ji){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:lE++}),this.uuid=co(),this.name="",this.source=new kd(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new mt(0,0),this.repeat=new mt(1,1),this.center=new mt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];const n={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==bd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case ca:e.x=e.x-Math.floor(e.x);break;case ws:e.x=e.x<0?0:1;break;case Jl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case ca:e.y=e.y-Math.floor(e.y);break;case ws:e.y=e.y<0?0:1;break;case Jl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}}yn.DEFAULT_IMAGE=null;yn.DEFAULT_MAPPING=bd;yn.DEFAULT_ANISOTROPY=1;class Gt{constructor(e=0,t=0,n=0,s=1){Gt.prototype.isVector4=!0,this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){const t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);const t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r;const l=e.elements,c=l[0],h=l[4],u=l[8],f=l[1],g=l[5],_=l[9],v=l[2],p=l[6],d=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-v)<.01&&Math.abs(_-p)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+v)<.1&&Math.abs(_+p)<.1&&Math.abs(c+g+d-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;const T=(c+1)/2,y=(g+1)/2,z=(d+1)/2,L=(h+f)/4,D=(u+v)/4,N=(_+p)/4;return T>y&&T>z?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=L/n,r=D/n):y>z?y<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),n=L/s,r=N/s):z<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(z),n=D/r,s=N/r),this.set(n,s,r,t),this}let w=Math.sqrt((p-_)*(p-_)+(u-v)*(u-v)+(f-h)*(f-h));return Math.abs(w)<.001&&(w=1),this.x=(p-_)/w,this.y=(u-v)/w,this.z=(f-h)/w,this.w=Math.acos((c+g+d-1)/2),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Math.max(e.x,Math.min(t.x,this.x)),this.y=Math.max(e.y,Math.min(t.y,this.y)),this.z=Math.max(e.z,Math.min(t.z,this.z)),this.w=Math.max(e.w,Math.min(t.w,this.w)),this}clampScalar(e,t){return this.x=Math.max(e,Math.min(t,this.x)),this.y=Math.max(e,Math.min(t,this.y)),this.z=Math.max(e,Math.min(t,this.z)),this.w=Math.max(e,Math.min(t,this.w)),this}clampLength(e,t){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(e,Math.min(t,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class cE extends Lr{constructor(e=1,t=1,n={}){super(),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=1,this.scissor=new Gt(0,0,e,t),this.scissorTest=!1,this.viewport=new Gt(0,0,e,t);const s={width:e,height:t,depth:1};n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:_i,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},n);const r=new yn(s,n.mapping,n.wrapS,n.wrapT,n.magFilter,n.minFilter,n.format,n.type,n.anisotropy,n.colorSpace);r.flipY=!1,r.generateMipmaps=n.generateMipmaps,r.internalFormat=n.internalFormat,this.textures=[];const o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.depthTexture=n.depthTexture,this.samples=n.samples}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let n=0,s=e.textures.length;n<s;n++)this.textures[n]=e.textures[n].clone(),this.textures[n].isRenderTargetTexture=!0;const t=Object.assign({},e.texture.image);return this.texture.source=new kd(t),this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Ns extends cE{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}}class Bd extends yn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=ri,this.minFilter=ri,this.wrapR=ws,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}}class uE extends yn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=ri,this.minFilter=ri,this.wrapR=ws,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class uo{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3];const f=r[o+0],g=r[o+1],_=r[o+2],v=r[o+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u;return}if(a===1){e[t+0]=f,e[t+1]=g,e[t+2]=_,e[t+3]=v;return}if(u!==v||l!==f||c!==g||h!==_){let p=1-a;const d=l*f+c*g+h*_+u*v,w=d>=0?1:-1,T=1-d*d;if(T>Number.EPSILON){const z=Math.sqrt(T),L=Math.atan2(z,d*w);p=Math.sin(p*L)/z,a=Math.sin(a*L)/z}const y=a*w;if(l=l*p+f*y,c=c*p+g*y,h=h*p+_*y,u=u*p+v*y,p===1-a){const z=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=z,c*=z,h*=z,u*=z}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){const a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],f=r[o+1],g=r[o+2],_=r[o+3];return e[t]=a*_+h*u+l*g-c*f,e[t+1]=l*_+h*f+c*u-a*g,e[t+2]=c*_+h*g+a*f-l*u,e[t+3]=h*_-a*u-l*f-c*g,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){const n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),f=l(n/2),g=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*g*_,this._y=c*g*u-f*h*_,this._z=c*h*_+f*g*u,this._w=c*h*u-f*g*_;break;case"YXZ":this._x=f*h*u+c*g*_,this._y=c*g*u-f*h*_,this._z=c*h*_-f*g*u,this._w=c*h*u+f*g*_;break;case"ZXY":this._x=f*h*u-c*g*_,this._y=c*g*u+f*h*_,this._z=c*h*_+f*g*u,this._w=c*h*u-f*g*_;break;case"ZYX":this._x=f*h*u-c*g*_,this._y=c*g*u+f*h*_,this._z=c*h*_-f*g*u,this._w=c*h*u+f*g*_;break;case"YZX":this._x=f*h*u+c*g*_,this._y=c*g*u+f*h*_,this._z=c*h*_-f*g*u,this._w=c*h*u-f*g*_;break;case"XZY":this._x=f*h*u-c*g*_,this._y=c*g*u-f*h*_,this._z=c*h*_+f*g*u,this._w=c*h*u+f*g*_;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){const n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){const t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],f=n+a+u;if(f>0){const g=.5/Math.sqrt(f+1);this._w=.25/g,this._x=(h-l)*g,this._y=(r-c)*g,this._z=(o-s)*g}else if(n>a&&n>u){const g=2*Math.sqrt(1+n-a-u);this._w=(h-l)/g,this._x=.25*g,this._y=(s+o)/g,this._z=(r+c)/g}else if(a>u){const g=2*Math.sqrt(1+a-n-u);this._w=(r-c)/g,this._x=(s+o)/g,this._y=.25*g,this._z=(l+h)/g}else{const g=2*Math.sqrt(1+u-n-a);this._w=(o-s)/g,this._x=(r+c)/g,this._y=(l+h)/g,this._z=.25*g}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<Number.EPSILON?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Tn(this.dot(e),-1,1)))}rotateTowards(e,t){const n=this.angleTo(e);if(n===0)return this;const s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){const n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);const n=this._x,s=this._y,r=this._z,o=this._w;let a=o*e._w+n*e._x+s*e._y+r*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;const l=1-a*a;if(l<=Number.EPSILON){const g=1-t;return this._w=g*o+t*this._w,this._x=g*n+t*this._x,this._y=g*s+t*this._y,this._z=g*r+t*this._z,this.normalize(),this}const c=Math.sqrt(l),h=Math.atan2(c,a),u=Math.sin((1-t)*h)/c,f=Math.sin(t*h)/c;return this._w=o*u+this._w*f,this._x=n*u+this._x*f,this._y=s*u+this._y*f,this._z=r*u+this._z*f,this._onChangeCallback(),this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){const e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class Y{constructor(e=0,t=0,n=0){Y.prototype.isVector3=!0,this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Ch.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Ch.setFromAxisAngle(e,t))}applyMatrix3(e){const t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){const t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){const t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){const t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Math.max(e.x,Math.min(t.x,this.x)),this.y=Math.max(e.y,Math.min(t.y,this.y)),this.z=Math.max(e.z,Math.min(t.z,this.z)),this}clampScalar(e,t){return this.x=Math.max(e,Math.min(t,this.x)),this.y=Math.max(e,Math.min(t,this.y)),this.z=Math.max(e,Math.min(t,this.z)),this}clampLength(e,t){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(e,Math.min(t,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){const n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){const t=e.lengthSq();if(t===0)return this.set(0,0,0);const n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return el.copy(this).projectOnVector(e),this.sub(el)}reflect(e){return this.sub(el.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const n=this.dot(e)/t;return Math.acos(Tn(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){const s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){const t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const el=new Y,Ch=new uo;class ho{constructor(e=new Y(1/0,1/0,1/0),t=new Y(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(jn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(jn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){const n=jn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);const n=e.geometry;if(n!==void 0){const r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,jn):jn.fromBufferAttribute(r,o),jn.applyMatrix4(e.matrixWorld),this.expandByPoint(jn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ao.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ao.copy(n.boundingBox)),Ao.applyMatrix4(e.matrixWorld),this.union(Ao)}const s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,jn),jn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Gr),Ro.subVectors(this.max,Gr),js.subVectors(e.a,Gr),Zs.subVectors(e.b,Gr),Js.subVectors(e.c,Gr),Gi.subVectors(Zs,js),Wi.subVectors(Js,Zs),hs.subVectors(js,Js);let t=[0,-Gi.z,Gi.y,0,-Wi.z,Wi.y,0,-hs.z,hs.y,Gi.z,0,-Gi.x,Wi.z,0,-Wi.x,hs.z,0,-hs.x,-Gi.y,Gi.x,0,-Wi.y,Wi.x,0,-hs.y,hs.x,0];return!tl(t,js,Zs,Js,Ro)||(t=[1,0,0,0,1,0,0,0,1],!tl(t,js,Zs,Js,Ro))?!1:(Co.crossVectors(Gi,Wi),t=[Co.x,Co.y,Co.z],tl(t,js,Zs,Js,Ro))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,jn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(jn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(wi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),wi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),wi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),wi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),wi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),wi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),wi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),wi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(wi),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}}const wi=[new Y,new Y,new Y,new Y,new Y,new Y,new Y,new Y],jn=new Y,Ao=new ho,js=new Y,Zs=new Y,Js=new Y,Gi=new Y,Wi=new Y,hs=new Y,Gr=new Y,Ro=new Y,Co=new Y,fs=new Y;function tl(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){fs.fromArray(i,r);const a=s.x*Math.abs(fs.x)+s.y*Math.abs(fs.y)+s.z*Math.abs(fs.z),l=e.dot(fs),c=t.dot(fs),h=n.dot(fs);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}const hE=new ho,Wr=new Y,nl=new Y;class Aa{constructor(e=new Y,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){const n=this.center;t!==void 0?n.copy(t):hE.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){const t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){const n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Wr.subVectors(e,this.center);const t=Wr.lengthSq();if(t>this.radius*this.radius){const n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Wr,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(nl.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Wr.copy(e.center).add(nl)),this.expandByPoint(Wr.copy(e.center).sub(nl))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}}const Ti=new Y,il=new Y,Po=new Y,$i=new Y,sl=new Y,Lo=new Y,rl=new Y;class Jc{constructor(e=new Y,t=new Y(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ti)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);const n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){const t=Ti.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ti.copy(this.origin).addScaledVector(this.direction,t),Ti.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){il.copy(e).add(t).multiplyScalar(.5),Po.copy(t).sub(e).normalize(),$i.copy(this.origin).sub(il);const r=e.distanceTo(t)*.5,o=-this.direction.dot(Po),a=$i.dot(this.direction),l=-$i.dot(Po),c=$i.lengthSq(),h=Math.abs(1-o*o);let u,f,g,_;if(h>0)if(u=o*l-a,f=o*a-l,_=r*h,u>=0)if(f>=-_)if(f<=_){const v=1/h;u*=v,f*=v,g=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),g=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),g=-u*u+f*(f+2*l)+c;else f<=-_?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),g=-u*u+f*(f+2*l)+c):f<=_?(u=0,f=Math.min(Math.max(-r,-l),r),g=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),g=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),g=-u*u+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(il).addScaledVector(Po,f),g}intersectSphere(e,t){Ti.subVectors(e.center,this.origin);const n=Ti.dot(this.direction),s=Ti.dot(Ti)-n*n,r=e.radius*e.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){const t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;const n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){const n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){const t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l;const c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(n=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(n=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),h>=0?(r=(e.min.y-f.y)*h,o=(e.max.y-f.y)*h):(r=(e.max.y-f.y)*h,o=(e.min.y-f.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-f.z)*u,l=(e.max.z-f.z)*u):(a=(e.max.z-f.z)*u,l=(e.min.z-f.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Ti)!==null}intersectTriangle(e,t,n,s,r){sl.subVectors(t,e),Lo.subVectors(n,e),rl.crossVectors(sl,Lo);let o=this.direction.dot(rl),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;$i.subVectors(this.origin,e);const l=a*this.direction.dot(Lo.crossVectors($i,Lo));if(l<0)return null;const c=a*this.direction.dot(sl.cross($i));if(c<0||l+c>o)return null;const h=-a*$i.dot(rl);return h<0?null:this.at(h/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Bt{constructor(e,t,n,s,r,o,a,l,c,h,u,f,g,_,v,p){Bt.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,f,g,_,v,p)}set(e,t,n,s,r,o,a,l,c,h,u,f,g,_,v,p){const d=this.elements;return d[0]=e,d[4]=t,d[8]=n,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=h,d[10]=u,d[14]=f,d[3]=g,d[7]=_,d[11]=v,d[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Bt().fromArray(this.elements)}copy(e){const t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){const t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){const t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){const t=this.elements,n=e.elements,s=1/Qs.setFromMatrixColumn(e,0).length(),r=1/Qs.setFromMatrixColumn(e,1).length(),o=1/Qs.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){const t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){const f=o*h,g=o*u,_=a*h,v=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=g+_*c,t[5]=f-v*c,t[9]=-a*l,t[2]=v-f*c,t[6]=_+g*c,t[10]=o*l}else if(e.order==="YXZ"){const f=l*h,g=l*u,_=c*h,v=c*u;t[0]=f+v*a,t[4]=_*a-g,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=g*a-_,t[6]=v+f*a,t[10]=o*l}else if(e.order==="ZXY"){const f=l*h,g=l*u,_=c*h,v=c*u;t[0]=f-v*a,t[4]=-o*u,t[8]=_+g*a,t[1]=g+_*a,t[5]=o*h,t[9]=v-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){const f=o*h,g=o*u,_=a*h,v=a*u;t[0]=l*h,t[4]=_*c-g,t[8]=f*c+v,t[1]=l*u,t[5]=v*c+f,t[9]=g*c-_,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){const f=o*l,g=o*c,_=a*l,v=a*c;t[0]=l*h,t[4]=v-f*u,t[8]=_*u+g,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=g*u+_,t[10]=f-v*u}else if(e.order==="XZY"){const f=o*l,g=o*c,_=a*l,v=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=f*u+v,t[5]=o*h,t[9]=g*u-_,t[2]=_*u-g,t[6]=a*h,t[10]=v*u+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(fE,e,dE)}lookAt(e,t,n){const s=this.elements;return Dn.subVectors(e,t),Dn.lengthSq()===0&&(Dn.z=1),Dn.normalize(),Xi.crossVectors(n,Dn),Xi.lengthSq()===0&&(Math.abs(n.z)===1?Dn.x+=1e-4:Dn.z+=1e-4,Dn.normalize(),Xi.crossVectors(n,Dn)),Xi.normalize(),Do.crossVectors(Dn,Xi),s[0]=Xi.x,s[4]=Do.x,s[8]=Dn.x,s[1]=Xi.y,s[5]=Do.y,s[9]=Dn.y,s[2]=Xi.z,s[6]=Do.z,s[10]=Dn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],f=n[9],g=n[13],_=n[2],v=n[6],p=n[10],d=n[14],w=n[3],T=n[7],y=n[11],z=n[15],L=s[0],D=s[4],N=s[8],b=s[12],S=s[1],R=s[5],V=s[9],I=s[13],j=s[2],$=s[6],Q=s[10],J=s[14],ne=s[3],de=s[7],he=s[11],_e=s[15];return r[0]=o*L+a*S+l*j+c*ne,r[4]=o*D+a*R+l*$+c*de,r[8]=o*N+a*V+l*Q+c*he,r[12]=o*b+a*I+l*J+c*_e,r[1]=h*L+u*S+f*j+g*ne,r[5]=h*D+u*R+f*$+g*de,r[9]=h*N+u*V+f*Q+g*he,r[13]=h*b+u*I+f*J+g*_e,r[2]=_*L+v*S+p*j+d*ne,r[6]=_*D+v*R+p*$+d*de,r[10]=_*N+v*V+p*Q+d*he,r[14]=_*b+v*I+p*J+d*_e,r[3]=w*L+T*S+y*j+z*ne,r[7]=w*D+T*R+y*$+z*de,r[11]=w*N+T*V+y*Q+z*he,r[15]=w*b+T*I+y*J+z*_e,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){const e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],f=e[10],g=e[14],_=e[3],v=e[7],p=e[11],d=e[15];return _*(+r*l*u-s*c*u-r*a*f+n*c*f+s*a*g-n*l*g)+v*(+t*l*g-t*c*f+r*o*f-s*o*g+s*c*h-r*l*h)+p*(+t*c*u-t*a*g-r*o*u+n*o*g+r*a*h-n*c*h)+d*(-s*a*h-t*l*u+t*a*f+s*o*u-n*o*f+n*l*h)}transpose(){const e=this.elements;let t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){const s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){const e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],f=e[10],g=e[11],_=e[12],v=e[13],p=e[14],d=e[15],w=u*p*c-v*f*c+v*l*g-a*p*g-u*l*d+a*f*d,T=_*f*c-h*p*c-_*l*g+o*p*g+h*l*d-o*f*d,y=h*v*c-_*u*c+_*a*g-o*v*g-h*a*d+o*u*d,z=_*u*l-h*v*l-_*a*f+o*v*f+h*a*p-o*u*p,L=t*w+n*T+s*y+r*z;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const D=1/L;return e[0]=w*D,e[1]=(v*f*r-u*p*r-v*s*g+n*p*g+u*s*d-n*f*d)*D,e[2]=(a*p*r-v*l*r+v*s*c-n*p*c-a*s*d+n*l*d)*D,e[3]=(u*l*r-a*f*r-u*s*c+n*f*c+a*s*g-n*l*g)*D,e[4]=T*D,e[5]=(h*p*r-_*f*r+_*s*g-t*p*g-h*s*d+t*f*d)*D,e[6]=(_*l*r-o*p*r-_*s*c+t*p*c+o*s*d-t*l*d)*D,e[7]=(o*f*r-h*l*r+h*s*c-t*f*c-o*s*g+t*l*g)*D,e[8]=y*D,e[9]=(_*u*r-h*v*r-_*n*g+t*v*g+h*n*d-t*u*d)*D,e[10]=(o*v*r-_*a*r+_*n*c-t*v*c-o*n*d+t*a*d)*D,e[11]=(h*a*r-o*u*r-h*n*c+t*u*c+o*n*g-t*a*g)*D,e[12]=z*D,e[13]=(h*v*s-_*u*s+_*n*f-t*v*f-h*n*p+t*u*p)*D,e[14]=(_*a*s-o*v*s-_*n*l+t*v*l+o*n*p-t*a*p)*D,e[15]=(o*u*s-h*a*s+h*n*l-t*u*l-o*n*f+t*a*f)*D,this}scale(e){const t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){const e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){const t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){const t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){const t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){const n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){const s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,f=r*c,g=r*h,_=r*u,v=o*h,p=o*u,d=a*u,w=l*c,T=l*h,y=l*u,z=n.x,L=n.y,D=n.z;return s[0]=(1-(v+d))*z,s[1]=(g+y)*z,s[2]=(_-T)*z,s[3]=0,s[4]=(g-y)*L,s[5]=(1-(f+d))*L,s[6]=(p+w)*L,s[7]=0,s[8]=(_+T)*D,s[9]=(p-w)*D,s[10]=(1-(f+v))*D,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){const s=this.elements;let r=Qs.set(s[0],s[1],s[2]).length();const o=Qs.set(s[4],s[5],s[6]).length(),a=Qs.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],Zn.copy(this);const c=1/r,h=1/o,u=1/a;return Zn.elements[0]*=c,Zn.elements[1]*=c,Zn.elements[2]*=c,Zn.elements[4]*=h,Zn.elements[5]*=h,Zn.elements[6]*=h,Zn.elements[8]*=u,Zn.elements[9]*=u,Zn.elements[10]*=u,t.setFromRotationMatrix(Zn),n.x=r,n.y=o,n.z=a,this}makePerspective(e,t,n,s,r,o,a=Ni){const l=this.elements,c=2*r/(t-e),h=2*r/(n-s),u=(t+e)/(t-e),f=(n+s)/(n-s);let g,_;if(a===Ni)g=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===ua)g=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=h,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=_,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ni){const l=this.elements,c=1/(t-e),h=1/(n-s),u=1/(o-r),f=(t+e)*c,g=(n+s)*h;let _,v;if(a===Ni)_=(o+r)*u,v=-2*u;else if(a===ua)_=r*u,v=-1*u;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-f,l[1]=0,l[5]=2*h,l[9]=0,l[13]=-g,l[2]=0,l[6]=0,l[10]=v,l[14]=-_,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){const t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){const n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}}const Qs=new Y,Zn=new Bt,fE=new Y(0,0,0),dE=new Y(1,1,1),Xi=new Y,Do=new Y,Dn=new Y,Ph=new Bt,Lh=new uo;class xi{constructor(e=0,t=0,n=0,s=xi.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){const s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],g=s[10];switch(t){case"XYZ":this._y=Math.asin(Tn(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,g),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Tn(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,g),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(Tn(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,g),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Tn(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,g),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Tn(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,g));break;case"XZY":this._z=Math.asin(-Tn(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,g),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Ph.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Ph,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Lh.setFromEuler(this),this.setFromQuaternion(Lh,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}xi.DEFAULT_ORDER="XYZ";class Qc{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}}let pE=0;const Dh=new Y,er=new uo,Ai=new Bt,No=new Y,$r=new Y,mE=new Y,gE=new uo,Nh=new Y(1,0,0),Uh=new Y(0,1,0),Ih=new Y(0,0,1),Fh={type:"added"},_E={type:"removed"},tr={type:"childadded",child:null},ol={type:"childremoved",child:null};class Jt extends Lr{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:pE++}),this.uuid=co(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=Jt.DEFAULT_UP.clone();const e=new Y,t=new xi,n=new uo,s=new Y(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Bt},normalMatrix:{value:new et}}),this.matrix=new Bt,this.matrixWorld=new Bt,this.matrixAutoUpdate=Jt.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=Jt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Qc,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return er.setFromAxisAngle(e,t),this.quaternion.multiply(er),this}rotateOnWorldAxis(e,t){return er.setFromAxisAngle(e,t),this.quaternion.premultiply(er),this}rotateX(e){return this.rotateOnAxis(Nh,e)}rotateY(e){return this.rotateOnAxis(Uh,e)}rotateZ(e){return this.rotateOnAxis(Ih,e)}translateOnAxis(e,t){return Dh.copy(e).applyQuaternion(this.quaternion),this.position.add(Dh.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Nh,e)}translateY(e){return this.translateOnAxis(Uh,e)}translateZ(e){return this.translateOnAxis(Ih,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ai.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?No.copy(e):No.set(e,t,n);const s=this.parent;this.updateWorldMatrix(!0,!1),$r.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ai.lookAt($r,No,this.up):Ai.lookAt(No,$r,this.up),this.quaternion.setFromRotationMatrix(Ai),s&&(Ai.extractRotation(s.matrixWorld),er.setFromRotationMatrix(Ai),this.quaternion.premultiply(er.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Fh),tr.child=e,this.dispatchEvent(tr),tr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}const t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(_E),ol.child=e,this.dispatchEvent(ol),ol.child=null),this}removeFromParent(){const e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ai.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ai.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ai),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Fh),tr.child=e,this.dispatchEvent(tr),tr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){const o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose($r,e,mE),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose($r,gE,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);const t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);const t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);const t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){const t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);const t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t){const n=this.parent;if(e===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){const t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){const u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){const a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),f=o(e.skeletons),g=o(e.animations),_=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),g.length>0&&(n.animations=g),_.length>0&&(n.nodes=_)}return n.object=s,n;function o(a){const l=[];for(const c in a){const h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){const s=e.children[n];this.add(s.clone())}return this}}Jt.DEFAULT_UP=new Y(0,1,0);Jt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Jt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const Jn=new Y,Ri=new Y,al=new Y,Ci=new Y,nr=new Y,ir=new Y,Oh=new Y,ll=new Y,cl=new Y,ul=new Y,hl=new Gt,fl=new Gt,dl=new Gt;class ni{constructor(e=new Y,t=new Y,n=new Y){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Jn.subVectors(e,t),s.cross(Jn);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Jn.subVectors(s,t),Ri.subVectors(n,t),al.subVectors(e,t);const o=Jn.dot(Jn),a=Jn.dot(Ri),l=Jn.dot(al),c=Ri.dot(Ri),h=Ri.dot(al),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;const f=1/u,g=(c*l-a*h)*f,_=(o*h-a*l)*f;return r.set(1-g-_,_,g)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Ci)===null?!1:Ci.x>=0&&Ci.y>=0&&Ci.x+Ci.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Ci)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ci.x),l.addScaledVector(o,Ci.y),l.addScaledVector(a,Ci.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return hl.setScalar(0),fl.setScalar(0),dl.setScalar(0),hl.fromBufferAttribute(e,t),fl.fromBufferAttribute(e,n),dl.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(hl,r.x),o.addScaledVector(fl,r.y),o.addScaledVector(dl,r.z),o}static isFrontFacing(e,t,n,s){return Jn.subVectors(n,t),Ri.subVectors(e,t),Jn.cross(Ri).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Jn.subVectors(this.c,this.b),Ri.subVectors(this.a,this.b),Jn.cross(Ri).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return ni.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return ni.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return ni.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return ni.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return ni.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){const n=this.a,s=this.b,r=this.c;let o,a;nr.subVectors(s,n),ir.subVectors(r,n),ll.subVectors(e,n);const l=nr.dot(ll),c=ir.dot(ll);if(l<=0&&c<=0)return t.copy(n);cl.subVectors(e,s);const h=nr.dot(cl),u=ir.dot(cl);if(h>=0&&u<=h)return t.copy(s);const f=l*u-h*c;if(f<=0&&l>=0&&h<=0)return o=l/(l-h),t.copy(n).addScaledVector(nr,o);ul.subVectors(e,r);const g=nr.dot(ul),_=ir.dot(ul);if(_>=0&&g<=_)return t.copy(r);const v=g*c-l*_;if(v<=0&&c>=0&&_<=0)return a=c/(c-_),t.copy(n).addScaledVector(ir,a);const p=h*_-g*u;if(p<=0&&u-h>=0&&g-_>=0)return Oh.subVectors(r,s),a=(u-h)/(u-h+(g-_)),t.copy(s).addScaledVector(Oh,a);const d=1/(p+v+f);return o=v*d,a=f*d,t.copy(n).addScaledVector(nr,o).addScaledVector(ir,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}}const zd={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},qi={h:0,s:0,l:0},Uo={h:0,s:0,l:0};function pl(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}class at{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){const s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=In){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,pt.toWorkingColorSpace(this,t),this}setRGB(e,t,n,s=pt.workingColorSpace){return this.r=e,this.g=t,this.b=n,pt.toWorkingColorSpace(this,s),this}setHSL(e,t,n,s=pt.workingColorSpace){if(e=tE(e,1),t=Tn(t,0,1),n=Tn(n,0,1),t===0)this.r=this.g=this.b=n;else{const r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=pl(o,r,e+1/3),this.g=pl(o,r,e),this.b=pl(o,r,e-1/3)}return pt.toWorkingColorSpace(this,s),this}setStyle(e,t=In){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=In){const n=zd[e.toLowerCase()];return n!==void 0?this.setHex(n,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Fi(e.r),this.g=Fi(e.g),this.b=Fi(e.b),this}copyLinearToSRGB(e){return this.r=pr(e.r),this.g=pr(e.g),this.b=pr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=In){return pt.fromWorkingColorSpace(dn.copy(this),e),Math.round(Tn(dn.r*255,0,255))*65536+Math.round(Tn(dn.g*255,0,255))*256+Math.round(Tn(dn.b*255,0,255))}getHexString(e=In){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=pt.workingColorSpace){pt.fromWorkingColorSpace(dn.copy(this),t);const n=dn.r,s=dn.g,r=dn.b,o=Math.max(n,s,r),a=Math.min(n,s,r);let l,c;const h=(a+o)/2;if(a===o)l=0,c=0;else{const u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=pt.workingColorSpace){return pt.fromWorkingColorSpace(dn.copy(this),t),e.r=dn.r,e.g=dn.g,e.b=dn.b,e}getStyle(e=In){pt.fromWorkingColorSpace(dn.copy(this),e);const t=dn.r,n=dn.g,s=dn.b;return e!==In?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(qi),this.setHSL(qi.h+e,qi.s+t,qi.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(qi),e.getHSL(Uo);const n=Za(qi.h,Uo.h,t),s=Za(qi.s,Uo.s,t),r=Za(qi.l,Uo.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){const t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const dn=new at;at.NAMES=zd;let vE=0;class Dr extends Lr{static get type(){return"Material"}get type(){return this.constructor.type}set type(e){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:vE++}),this.uuid=co(),this.name="",this.blending=fr,this.side=is,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Hl,this.blendDst=Vl,this.blendEquation=Es,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new at(0,0,0),this.blendAlpha=0,this.depthFunc=Sr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Mh,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ys,this.stencilZFail=Ys,this.stencilZPass=Ys,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(const t in e){const n=e[t];if(n===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){const t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});const n={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==fr&&(n.blending=this.blending),this.side!==is&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==Hl&&(n.blendSrc=this.blendSrc),this.blendDst!==Vl&&(n.blendDst=this.blendDst),this.blendEquation!==Es&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==Sr&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Mh&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Ys&&(n.stencilFail=this.stencilFail),this.stencilZFail!==Ys&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==Ys&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(t){const r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;const t=e.clippingPlanes;let n=null;if(t!==null){const s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}}class eu extends Dr{static get type(){return"MeshBasicMaterial"}constructor(e){super(),this.isMeshBasicMaterial=!0,this.color=new at(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new xi,this.combine=Ed,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}}const Xt=new Y,Io=new mt;class vi{constructor(e,t,n=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Sh,this.updateRanges=[],this.gpuType=Di,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Io.fromBufferAttribute(this,t),Io.applyMatrix3(e),this.setXY(t,Io.x,Io.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.applyMatrix3(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.applyMatrix4(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.applyNormalMatrix(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.transformDirection(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=Vr(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=wn(n,this.array)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Vr(t,this.array)),t}setX(e,t){return this.normalized&&(t=wn(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Vr(t,this.array)),t}setY(e,t){return this.normalized&&(t=wn(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Vr(t,this.array)),t}setZ(e,t){return this.normalized&&(t=wn(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Vr(t,this.array)),t}setW(e,t){return this.normalized&&(t=wn(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=wn(t,this.array),n=wn(n,this.array)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=wn(t,this.array),n=wn(n,this.array),s=wn(s,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=wn(t,this.array),n=wn(n,this.array),s=wn(s,this.array),r=wn(r,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==Sh&&(e.usage=this.usage),e}}class Hd extends vi{constructor(e,t,n){super(new Uint16Array(e),t,n)}}class Vd extends vi{constructor(e,t,n){super(new Uint32Array(e),t,n)}}class Xn extends vi{constructor(e,t,n){super(new Float32Array(e),t,n)}}let xE=0;const Hn=new Bt,ml=new Jt,sr=new Y,Nn=new ho,Xr=new ho,ln=new Y;class Mi extends Lr{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:xE++}),this.uuid=co(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Od(e)?Vd:Hd)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){const t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);const n=this.attributes.normal;if(n!==void 0){const r=new et().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return Hn.makeRotationFromQuaternion(e),this.applyMatrix4(Hn),this}rotateX(e){return Hn.makeRotationX(e),this.applyMatrix4(Hn),this}rotateY(e){return Hn.makeRotationY(e),this.applyMatrix4(Hn),this}rotateZ(e){return Hn.makeRotationZ(e),this.applyMatrix4(Hn),this}translate(e,t,n){return Hn.makeTranslation(e,t,n),this.applyMatrix4(Hn),this}scale(e,t,n){return Hn.makeScale(e,t,n),this.applyMatrix4(Hn),this}lookAt(e){return ml.lookAt(e),ml.updateMatrix(),this.applyMatrix4(ml.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(sr).negate(),this.translate(sr.x,sr.y,sr.z),this}setFromPoints(e){const t=this.getAttribute("position");if(t===void 0){const n=[];for(let s=0,r=e.length;s<r;s++){const o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Xn(n,3))}else{for(let n=0,s=t.count;n<s;n++){const r=e[n];t.setXYZ(n,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ho);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Y(-1/0,-1/0,-1/0),new Y(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){const r=t[n];Nn.setFromBufferAttribute(r),this.morphTargetsRelative?(ln.addVectors(this.boundingBox.min,Nn.min),this.boundingBox.expandByPoint(ln),ln.addVectors(this.boundingBox.max,Nn.max),this.boundingBox.expandByPoint(ln)):(this.boundingBox.expandByPoint(Nn.min),this.boundingBox.expandByPoint(Nn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Aa);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Y,1/0);return}if(e){const n=this.boundingSphere.center;if(Nn.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){const a=t[r];Xr.setFromBufferAttribute(a),this.morphTargetsRelative?(ln.addVectors(Nn.min,Xr.min),Nn.expandByPoint(ln),ln.addVectors(Nn.max,Xr.max),Nn.expandByPoint(ln)):(Nn.expandByPoint(Xr.min),Nn.expandByPoint(Xr.max))}Nn.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)ln.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(ln));if(t)for(let r=0,o=t.length;r<o;r++){const a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)ln.fromBufferAttribute(a,c),l&&(sr.fromBufferAttribute(e,c),ln.add(sr)),s=Math.max(s,n.distanceToSquared(ln))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const n=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new vi(new Float32Array(4*n.count),4));const o=this.getAttribute("tangent"),a=[],l=[];for(let N=0;N<n.count;N++)a[N]=new Y,l[N]=new Y;const c=new Y,h=new Y,u=new Y,f=new mt,g=new mt,_=new mt,v=new Y,p=new Y;function d(N,b,S){c.fromBufferAttribute(n,N),h.fromBufferAttribute(n,b),u.fromBufferAttribute(n,S),f.fromBufferAttribute(r,N),g.fromBufferAttribute(r,b),_.fromBufferAttribute(r,S),h.sub(c),u.sub(c),g.sub(f),_.sub(f);const R=1/(g.x*_.y-_.x*g.y);isFinite(R)&&(v.copy(h).multiplyScalar(_.y).addScaledVector(u,-g.y).multiplyScalar(R),p.copy(u).multiplyScalar(g.x).addScaledVector(h,-_.x).multiplyScalar(R),a[N].add(v),a[b].add(v),a[S].add(v),l[N].add(p),l[b].add(p),l[S].add(p))}let w=this.groups;w.length===0&&(w=[{start:0,count:e.count}]);for(let N=0,b=w.length;N<b;++N){const S=w[N],R=S.start,V=S.count;for(let I=R,j=R+V;I<j;I+=3)d(e.getX(I+0),e.getX(I+1),e.getX(I+2))}const T=new Y,y=new Y,z=new Y,L=new Y;function D(N){z.fromBufferAttribute(s,N),L.copy(z);const b=a[N];T.copy(b),T.sub(z.multiplyScalar(z.dot(b))).normalize(),y.crossVectors(L,b);const R=y.dot(l[N])<0?-1:1;o.setXYZW(N,T.x,T.y,T.z,R)}for(let N=0,b=w.length;N<b;++N){const S=w[N],R=S.start,V=S.count;for(let I=R,j=R+V;I<j;I+=3)D(e.getX(I+0)),D(e.getX(I+1)),D(e.getX(I+2))}}computeVertexNormals(){const e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new vi(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,g=n.count;f<g;f++)n.setXYZ(f,0,0,0);const s=new Y,r=new Y,o=new Y,a=new Y,l=new Y,c=new Y,h=new Y,u=new Y;if(e)for(let f=0,g=e.count;f<g;f+=3){const _=e.getX(f+0),v=e.getX(f+1),p=e.getX(f+2);s.fromBufferAttribute(t,_),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,_),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,p),a.add(h),l.add(h),c.add(h),n.setXYZ(_,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let f=0,g=t.count;f<g;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){const e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)ln.fromBufferAttribute(e,t),ln.normalize(),e.setXYZ(t,ln.x,ln.y,ln.z)}toNonIndexed(){function e(a,l){const c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h);let g=0,_=0;for(let v=0,p=l.length;v<p;v++){a.isInterleavedBufferAttribute?g=l[v]*a.data.stride+a.offset:g=l[v]*h;for(let d=0;d<h;d++)f[_++]=c[g++]}return new vi(f,h,u)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const t=new Mi,n=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=e(l,n);t.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){const f=c[h],g=e(f,n);l.push(g)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){const e={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};const t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});const n=this.attributes;for(const l in n){const c=n[l];e.data.attributes[l]=c.toJSON(e.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){const g=c[u];h.push(g.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(e.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const t={};this.name=e.name;const n=e.index;n!==null&&this.setIndex(n.clone(t));const s=e.attributes;for(const c in s){const h=s[c];this.setAttribute(c,h.clone(t))}const r=e.morphAttributes;for(const c in r){const h=[],u=r[c];for(let f=0,g=u.length;f<g;f++)h.push(u[f].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;const o=e.groups;for(let c=0,h=o.length;c<h;c++){const u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}const a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const kh=new Bt,ds=new Jc,Fo=new Aa,Bh=new Y,Oo=new Y,ko=new Y,Bo=new Y,gl=new Y,zo=new Y,zh=new Y,Ho=new Y;class pn extends Jt{constructor(e=new Mi,t=new eu){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){const t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){const s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){const n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);const a=this.morphTargetInfluences;if(r&&a){zo.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const h=a[l],u=r[l];h!==0&&(gl.fromBufferAttribute(u,e),o?zo.addScaledVector(gl,h):zo.addScaledVector(gl.sub(t),h))}t.add(zo)}return t}raycast(e,t){const n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Fo.copy(n.boundingSphere),Fo.applyMatrix4(r),ds.copy(e.ray).recast(e.near),!(Fo.containsPoint(ds.origin)===!1&&(ds.intersectSphere(Fo,Bh)===null||ds.origin.distanceToSquared(Bh)>(e.far-e.near)**2))&&(kh.copy(r).invert(),ds.copy(e.ray).applyMatrix4(kh),!(n.boundingBox!==null&&ds.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,ds)))}_computeIntersections(e,t,n){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,g=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,v=f.length;_<v;_++){const p=f[_],d=o[p.materialIndex],w=Math.max(p.start,g.start),T=Math.min(a.count,Math.min(p.start+p.count,g.start+g.count));for(let y=w,z=T;y<z;y+=3){const L=a.getX(y),D=a.getX(y+1),N=a.getX(y+2);s=Vo(this,d,e,n,c,h,u,L,D,N),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{const _=Math.max(0,g.start),v=Math.min(a.count,g.start+g.count);for(let p=_,d=v;p<d;p+=3){const w=a.getX(p),T=a.getX(p+1),y=a.getX(p+2);s=Vo(this,o,e,n,c,h,u,w,T,y),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,v=f.length;_<v;_++){const p=f[_],d=o[p.materialIndex],w=Math.max(p.start,g.start),T=Math.min(l.count,Math.min(p.start+p.count,g.start+g.count));for(let y=w,z=T;y<z;y+=3){const L=y,D=y+1,N=y+2;s=Vo(this,d,e,n,c,h,u,L,D,N),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{const _=Math.max(0,g.start),v=Math.min(l.count,g.start+g.count);for(let p=_,d=v;p<d;p+=3){const w=p,T=p+1,y=p+2;s=Vo(this,o,e,n,c,h,u,w,T,y),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}}function ME(i,e,t,n,s,r,o,a){let l;if(e.side===An?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===is,a),l===null)return null;Ho.copy(a),Ho.applyMatrix4(i.matrixWorld);const c=t.ray.origin.distanceTo(Ho);return c<t.near||c>t.far?null:{distance:c,point:Ho.clone(),object:i}}function Vo(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Oo),i.getVertexPosition(l,ko),i.getVertexPosition(c,Bo);const h=ME(i,e,t,n,Oo,ko,Bo,zh);if(h){const u=new Y;ni.getBarycoord(zh,Oo,ko,Bo,u),s&&(h.uv=ni.getInterpolatedAttribute(s,a,l,c,u,new mt)),r&&(h.uv1=ni.getInterpolatedAttribute(r,a,l,c,u,new mt)),o&&(h.normal=ni.getInterpolatedAttribute(o,a,l,c,u,new Y),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));const f={a,b:l,c,normal:new Y,materialIndex:0};ni.getNormal(Oo,ko,Bo,f.normal),h.face=f,h.barycoord=u}return h}class Us extends Mi{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],h=[],u=[];let f=0,g=0;_("z","y","x",-1,-1,n,t,e,o,r,0),_("z","y","x",1,-1,n,t,-e,o,r,1),_("x","z","y",1,1,e,n,t,s,o,2),_("x","z","y",1,-1,e,n,-t,s,o,3),_("x","y","z",1,-1,e,t,n,s,r,4),_("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Xn(c,3)),this.setAttribute("normal",new Xn(h,3)),this.setAttribute("uv",new Xn(u,2));function _(v,p,d,w,T,y,z,L,D,N,b){const S=y/D,R=z/N,V=y/2,I=z/2,j=L/2,$=D+1,Q=N+1;let J=0,ne=0;const de=new Y;for(let he=0;he<Q;he++){const _e=he*R-I;for(let ye=0;ye<$;ye++){const ge=ye*S-V;de[v]=ge*w,de[p]=_e*T,de[d]=j,c.push(de.x,de.y,de.z),de[v]=0,de[p]=0,de[d]=L>0?1:-1,h.push(de.x,de.y,de.z),u.push(ye/D),u.push(1-he/N),J+=1}}for(let he=0;he<N;he++)for(let _e=0;_e<D;_e++){const ye=f+_e+$*he,ge=f+_e+$*(he+1),re=f+(_e+1)+$*(he+1),ce=f+(_e+1)+$*he;l.push(ye,ge,ce),l.push(ge,re,ce),ne+=6}a.addGroup(g,ne,b),g+=ne,f+=J}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Us(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}}function Tr(i){const e={};for(const t in i){e[t]={};for(const n in i[t]){const s=i[t][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone():Array.isArray(s)?e[t][n]=s.slice():e[t][n]=s}}return e}function Mn(i){const e={};for(let t=0;t<i.length;t++){const n=Tr(i[t]);for(const s in n)e[s]=n[s]}return e}function SE(i){const e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Gd(i){const e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:pt.workingColorSpace}const yE={clone:Tr,merge:Mn};var EE=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,bE=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class ss extends Dr{static get type(){return"ShaderMaterial"}constructor(e){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=EE,this.fragmentShader=bE,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Tr(e.uniforms),this.uniformsGroups=SE(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){const t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;const n={};for(const s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}}class Wd extends Jt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Bt,this.projectionMatrix=new Bt,this.projectionMatrixInverse=new Bt,this.coordinateSystem=Ni}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const Yi=new Y,Hh=new mt,Vh=new mt;class $n extends Wd{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){const t=.5*this.getFilmHeight()/e;this.fov=wc*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){const e=Math.tan(ja*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return wc*2*Math.atan(Math.tan(ja*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Yi.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Yi.x,Yi.y).multiplyScalar(-e/Yi.z),Yi.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Yi.x,Yi.y).multiplyScalar(-e/Yi.z)}getViewSize(e,t){return this.getViewBounds(e,Hh,Vh),t.subVectors(Vh,Hh)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=this.near;let t=e*Math.tan(ja*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}const a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}}const rr=-90,or=1;class wE extends Jt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new $n(rr,or,e,t);s.layers=this.layers,this.add(s);const r=new $n(rr,or,e,t);r.layers=this.layers,this.add(r);const o=new $n(rr,or,e,t);o.layers=this.layers,this.add(o);const a=new $n(rr,or,e,t);a.layers=this.layers,this.add(a);const l=new $n(rr,or,e,t);l.layers=this.layers,this.add(l);const c=new $n(rr,or,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(const c of t)this.remove(c);if(e===Ni)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===ua)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(const c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();const{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),f=e.getActiveCubeFace(),g=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;const v=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,e.setRenderTarget(n,0,s),e.render(t,r),e.setRenderTarget(n,1,s),e.render(t,o),e.setRenderTarget(n,2,s),e.render(t,a),e.setRenderTarget(n,3,s),e.render(t,l),e.setRenderTarget(n,4,s),e.render(t,c),n.texture.generateMipmaps=v,e.setRenderTarget(n,5,s),e.render(t,h),e.setRenderTarget(u,f,g),e.xr.enabled=_,n.texture.needsPMREMUpdate=!0}}class $d extends yn{constructor(e,t,n,s,r,o,a,l,c,h){e=e!==void 0?e:[],t=t!==void 0?t:yr,super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}}class TE extends Ns{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;const n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new $d(s,t.mapping,t.wrapS,t.wrapT,t.magFilter,t.minFilter,t.format,t.type,t.anisotropy,t.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=t.generateMipmaps!==void 0?t.generateMipmaps:!1,this.texture.minFilter=t.minFilter!==void 0?t.minFilter:_i}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;const n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Us(5,5,5),r=new ss({name:"CubemapFromEquirect",uniforms:Tr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:An,blending:es});r.uniforms.tEquirect.value=t;const o=new pn(s,r),a=t.minFilter;return t.minFilter===Ts&&(t.minFilter=_i),new wE(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t,n,s){const r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}}const _l=new Y,AE=new Y,RE=new et;class Zi{constructor(e=new Y(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){const s=_l.subVectors(n,t).cross(AE.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){const e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){const n=e.delta(_l),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;const r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(n,r)}intersectsLine(e){const t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){const n=t||RE.getNormalMatrix(e),s=this.coplanarPoint(_l).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}}const ps=new Aa,Go=new Y;class tu{constructor(e=new Zi,t=new Zi,n=new Zi,s=new Zi,r=new Zi,o=new Zi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){const a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){const t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ni){const n=this.planes,s=e.elements,r=s[0],o=s[1],a=s[2],l=s[3],c=s[4],h=s[5],u=s[6],f=s[7],g=s[8],_=s[9],v=s[10],p=s[11],d=s[12],w=s[13],T=s[14],y=s[15];if(n[0].setComponents(l-r,f-c,p-g,y-d).normalize(),n[1].setComponents(l+r,f+c,p+g,y+d).normalize(),n[2].setComponents(l+o,f+h,p+_,y+w).normalize(),n[3].setComponents(l-o,f-h,p-_,y-w).normalize(),n[4].setComponents(l-a,f-u,p-v,y-T).normalize(),t===Ni)n[5].setComponents(l+a,f+u,p+v,y+T).normalize();else if(t===ua)n[5].setComponents(a,u,v,T).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),ps.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{const t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),ps.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(ps)}intersectsSprite(e){return ps.center.set(0,0,0),ps.radius=.7071067811865476,ps.applyMatrix4(e.matrixWorld),this.intersectsSphere(ps)}intersectsSphere(e){const t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){const t=this.planes;for(let n=0;n<6;n++){const s=t[n];if(Go.x=s.normal.x>0?e.max.x:e.min.x,Go.y=s.normal.y>0?e.max.y:e.min.y,Go.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Go)<0)return!1}return!0}containsPoint(e){const t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}function Xd(){let i=null,e=!1,t=null,n=null;function s(r,o){t(r,o),n=i.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function CE(i){const e=new WeakMap;function t(a,l){const c=a.array,h=a.usage,u=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,h),a.onUploadCallback();let g;if(c instanceof Float32Array)g=i.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?g=i.HALF_FLOAT:g=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)g=i.SHORT;else if(c instanceof Uint32Array)g=i.UNSIGNED_INT;else if(c instanceof Int32Array)g=i.INT;else if(c instanceof Int8Array)g=i.BYTE;else if(c instanceof Uint8Array)g=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)g=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:g,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){const h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((g,_)=>g.start-_.start);let f=0;for(let g=1;g<u.length;g++){const _=u[f],v=u[g];v.start<=_.start+_.count+1?_.count=Math.max(_.count,v.start+v.count-_.start):(++f,u[f]=v)}u.length=f+1;for(let g=0,_=u.length;g<_;g++){const v=u[g];i.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}class fo extends Mi{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};const r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,f=t/l,g=[],_=[],v=[],p=[];for(let d=0;d<h;d++){const w=d*f-o;for(let T=0;T<c;T++){const y=T*u-r;_.push(y,-w,0),v.push(0,0,1),p.push(T/a),p.push(1-d/l)}}for(let d=0;d<l;d++)for(let w=0;w<a;w++){const T=w+c*d,y=w+c*(d+1),z=w+1+c*(d+1),L=w+1+c*d;g.push(T,y,L),g.push(y,z,L)}this.setIndex(g),this.setAttribute("position",new Xn(_,3)),this.setAttribute("normal",new Xn(v,3)),this.setAttribute("uv",new Xn(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new fo(e.width,e.height,e.widthSegments,e.heightSegments)}}var PE=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,LE=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,DE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,NE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,UE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,IE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,FE=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,OE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,kE=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,BE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,zE=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,HE=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,VE=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,GE=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,WE=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,$E=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,XE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,qE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,YE=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,KE=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,jE=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,ZE=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,JE=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,QE=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,eb=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,tb=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,nb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,ib=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,sb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,rb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,ob="gl_FragColor = linearToOutputTexel( gl_FragColor );",ab=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,lb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,cb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,ub=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,hb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,fb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,db=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,pb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,mb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,gb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,_b=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,vb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,xb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Mb=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Sb=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,yb=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,Eb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,bb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,wb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Tb=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Ab=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Rb=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Cb=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Pb=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Lb=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Db=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Nb=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ub=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ib=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Fb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Ob=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,kb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Bb=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,zb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Hb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Vb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Gb=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Wb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,$b=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Xb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,qb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Yb=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Kb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,jb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Zb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,Jb=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Qb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,ew=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,tw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,nw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,iw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,sw=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,rw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,ow=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,aw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,lw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,cw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,uw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,hw=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		return step( compare, unpackRGBAToDepth( texture2D( depths, uv ) ) );
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow (sampler2D shadow, vec2 uv, float compare ){
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		float hard_shadow = step( compare , distribution.x );
		if (hard_shadow != 1.0 ) {
			float distance = compare - distribution.x ;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,fw=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,dw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,pw=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,mw=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,gw=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,_w=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,vw=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,xw=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Mw=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Sw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,yw=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Ew=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,bw=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
		
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
		
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		
		#else
		
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,ww=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Tw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Aw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Rw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const Cw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Pw=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Lw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Dw=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Nw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Uw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Iw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Fw=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	float fragCoordZ = 0.5 * vHighPrecisionZW[0] / vHighPrecisionZW[1] + 0.5;
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Ow=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,kw=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,Bw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,zw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Hw=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Vw=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Gw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Ww=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,$w=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Xw=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,qw=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Yw=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Kw=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,jw=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Zw=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Jw=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Qw=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,eT=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,tT=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,nT=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,iT=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,sT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,rT=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,oT=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,aT=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,lT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,nt={alphahash_fragment:PE,alphahash_pars_fragment:LE,alphamap_fragment:DE,alphamap_pars_fragment:NE,alphatest_fragment:UE,alphatest_pars_fragment:IE,aomap_fragment:FE,aomap_pars_fragment:OE,batching_pars_vertex:kE,batching_vertex:BE,begin_vertex:zE,beginnormal_vertex:HE,bsdfs:VE,iridescence_fragment:GE,bumpmap_pars_fragment:WE,clipping_planes_fragment:$E,clipping_planes_pars_fragment:XE,clipping_planes_pars_vertex:qE,clipping_planes_vertex:YE,color_fragment:KE,color_pars_fragment:jE,color_pars_vertex:ZE,color_vertex:JE,common:QE,cube_uv_reflection_fragment:eb,defaultnormal_vertex:tb,displacementmap_pars_vertex:nb,displacementmap_vertex:ib,emissivemap_fragment:sb,emissivemap_pars_fragment:rb,colorspace_fragment:ob,colorspace_pars_fragment:ab,envmap_fragment:lb,envmap_common_pars_fragment:cb,envmap_pars_fragment:ub,envmap_pars_vertex:hb,envmap_physical_pars_fragment:yb,envmap_vertex:fb,fog_vertex:db,fog_pars_vertex:pb,fog_fragment:mb,fog_pars_fragment:gb,gradientmap_pars_fragment:_b,lightmap_pars_fragment:vb,lights_lambert_fragment:xb,lights_lambert_pars_fragment:Mb,lights_pars_begin:Sb,lights_toon_fragment:Eb,lights_toon_pars_fragment:bb,lights_phong_fragment:wb,lights_phong_pars_fragment:Tb,lights_physical_fragment:Ab,lights_physical_pars_fragment:Rb,lights_fragment_begin:Cb,lights_fragment_maps:Pb,lights_fragment_end:Lb,logdepthbuf_fragment:Db,logdepthbuf_pars_fragment:Nb,logdepthbuf_pars_vertex:Ub,logdepthbuf_vertex:Ib,map_fragment:Fb,map_pars_fragment:Ob,map_particle_fragment:kb,map_particle_pars_fragment:Bb,metalnessmap_fragment:zb,metalnessmap_pars_fragment:Hb,morphinstance_vertex:Vb,morphcolor_vertex:Gb,morphnormal_vertex:Wb,morphtarget_pars_vertex:$b,morphtarget_vertex:Xb,normal_fragment_begin:qb,normal_fragment_maps:Yb,normal_pars_fragment:Kb,normal_pars_vertex:jb,normal_vertex:Zb,normalmap_pars_fragment:Jb,clearcoat_normal_fragment_begin:Qb,clearcoat_normal_fragment_maps:ew,clearcoat_pars_fragment:tw,iridescence_pars_fragment:nw,opaque_fragment:iw,packing:sw,premultiplied_alpha_fragment:rw,project_vertex:ow,dithering_fragment:aw,dithering_pars_fragment:lw,roughnessmap_fragment:cw,roughnessmap_pars_fragment:uw,shadowmap_pars_fragment:hw,shadowmap_pars_vertex:fw,shadowmap_vertex:dw,shadowmask_pars_fragment:pw,skinbase_vertex:mw,skinning_pars_vertex:gw,skinning_vertex:_w,skinnormal_vertex:vw,specularmap_fragment:xw,specularmap_pars_fragment:Mw,tonemapping_fragment:Sw,tonemapping_pars_fragment:yw,transmission_fragment:Ew,transmission_pars_fragment:bw,uv_pars_fragment:ww,uv_pars_vertex:Tw,uv_vertex:Aw,worldpos_vertex:Rw,background_vert:Cw,background_frag:Pw,backgroundCube_vert:Lw,backgroundCube_frag:Dw,cube_vert:Nw,cube_frag:Uw,depth_vert:Iw,depth_frag:Fw,distanceRGBA_vert:Ow,distanceRGBA_frag:kw,equirect_vert:Bw,equirect_frag:zw,linedashed_vert:Hw,linedashed_frag:Vw,meshbasic_vert:Gw,meshbasic_frag:Ww,meshlambert_vert:$w,meshlambert_frag:Xw,meshmatcap_vert:qw,meshmatcap_frag:Yw,meshnormal_vert:Kw,meshnormal_frag:jw,meshphong_vert:Zw,meshphong_frag:Jw,meshphysical_vert:Qw,meshphysical_frag:eT,meshtoon_vert:tT,meshtoon_frag:nT,points_vert:iT,points_frag:sT,shadow_vert:rT,shadow_frag:oT,sprite_vert:aT,sprite_frag:lT},Te={common:{diffuse:{value:new at(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new mt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new at(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new at(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new at(16777215)},opacity:{value:1},center:{value:new mt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}},mi={basic:{uniforms:Mn([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.fog]),vertexShader:nt.meshbasic_vert,fragmentShader:nt.meshbasic_frag},lambert:{uniforms:Mn([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,Te.lights,{emissive:{value:new at(0)}}]),vertexShader:nt.meshlambert_vert,fragmentShader:nt.meshlambert_frag},phong:{uniforms:Mn([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,Te.lights,{emissive:{value:new at(0)},specular:{value:new at(1118481)},shininess:{value:30}}]),vertexShader:nt.meshphong_vert,fragmentShader:nt.meshphong_frag},standard:{uniforms:Mn([Te.common,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.roughnessmap,Te.metalnessmap,Te.fog,Te.lights,{emissive:{value:new at(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:nt.meshphysical_vert,fragmentShader:nt.meshphysical_frag},toon:{uniforms:Mn([Te.common,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.gradientmap,Te.fog,Te.lights,{emissive:{value:new at(0)}}]),vertexShader:nt.meshtoon_vert,fragmentShader:nt.meshtoon_frag},matcap:{uniforms:Mn([Te.common,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,{matcap:{value:null}}]),vertexShader:nt.meshmatcap_vert,fragmentShader:nt.meshmatcap_frag},points:{uniforms:Mn([Te.points,Te.fog]),vertexShader:nt.points_vert,fragmentShader:nt.points_frag},dashed:{uniforms:Mn([Te.common,Te.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:nt.linedashed_vert,fragmentShader:nt.linedashed_frag},depth:{uniforms:Mn([Te.common,Te.displacementmap]),vertexShader:nt.depth_vert,fragmentShader:nt.depth_frag},normal:{uniforms:Mn([Te.common,Te.bumpmap,Te.normalmap,Te.displacementmap,{opacity:{value:1}}]),vertexShader:nt.meshnormal_vert,fragmentShader:nt.meshnormal_frag},sprite:{uniforms:Mn([Te.sprite,Te.fog]),vertexShader:nt.sprite_vert,fragmentShader:nt.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:nt.background_vert,fragmentShader:nt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:nt.backgroundCube_vert,fragmentShader:nt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:nt.cube_vert,fragmentShader:nt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:nt.equirect_vert,fragmentShader:nt.equirect_frag},distanceRGBA:{uniforms:Mn([Te.common,Te.displacementmap,{referencePosition:{value:new Y},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:nt.distanceRGBA_vert,fragmentShader:nt.distanceRGBA_frag},shadow:{uniforms:Mn([Te.lights,Te.fog,{color:{value:new at(0)},opacity:{value:1}}]),vertexShader:nt.shadow_vert,fragmentShader:nt.shadow_frag}};mi.physical={uniforms:Mn([mi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new mt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new at(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new mt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new at(0)},specularColor:{value:new at(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new mt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:nt.meshphysical_vert,fragmentShader:nt.meshphysical_frag};const Wo={r:0,b:0,g:0},ms=new xi,cT=new Bt;function uT(i,e,t,n,s,r,o){const a=new at(0);let l=r===!0?0:1,c,h,u=null,f=0,g=null;function _(w){let T=w.isScene===!0?w.background:null;return T&&T.isTexture&&(T=(w.backgroundBlurriness>0?t:e).get(T)),T}function v(w){let T=!1;const y=_(w);y===null?d(a,l):y&&y.isColor&&(d(y,1),T=!0);const z=i.xr.getEnvironmentBlendMode();z==="additive"?n.buffers.color.setClear(0,0,0,1,o):z==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||T)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function p(w,T){const y=_(T);y&&(y.isCubeTexture||y.mapping===wa)?(h===void 0&&(h=new pn(new Us(1,1,1),new ss({name:"BackgroundCubeMaterial",uniforms:Tr(mi.backgroundCube.uniforms),vertexShader:mi.backgroundCube.vertexShader,fragmentShader:mi.backgroundCube.fragmentShader,side:An,depthTest:!1,depthWrite:!1,fog:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(z,L,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),ms.copy(T.backgroundRotation),ms.x*=-1,ms.y*=-1,ms.z*=-1,y.isCubeTexture&&y.isRenderTargetTexture===!1&&(ms.y*=-1,ms.z*=-1),h.material.uniforms.envMap.value=y,h.material.uniforms.flipEnvMap.value=y.isCubeTexture&&y.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(cT.makeRotationFromEuler(ms)),h.material.toneMapped=pt.getTransfer(y.colorSpace)!==At,(u!==y||f!==y.version||g!==i.toneMapping)&&(h.material.needsUpdate=!0,u=y,f=y.version,g=i.toneMapping),h.layers.enableAll(),w.unshift(h,h.geometry,h.material,0,0,null)):y&&y.isTexture&&(c===void 0&&(c=new pn(new fo(2,2),new ss({name:"BackgroundMaterial",uniforms:Tr(mi.background.uniforms),vertexShader:mi.background.vertexShader,fragmentShader:mi.background.fragmentShader,side:is,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=y,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.toneMapped=pt.getTransfer(y.colorSpace)!==At,y.matrixAutoUpdate===!0&&y.updateMatrix(),c.material.uniforms.uvTransform.value.copy(y.matrix),(u!==y||f!==y.version||g!==i.toneMapping)&&(c.material.needsUpdate=!0,u=y,f=y.version,g=i.toneMapping),c.layers.enableAll(),w.unshift(c,c.geometry,c.material,0,0,null))}function d(w,T){w.getRGB(Wo,Gd(i)),n.buffers.color.setClear(Wo.r,Wo.g,Wo.b,T,o)}return{getClearColor:function(){return a},setClearColor:function(w,T=1){a.set(w),l=T,d(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(w){l=w,d(a,l)},render:v,addToRenderList:p}}function hT(i,e){const t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null);let r=s,o=!1;function a(S,R,V,I,j){let $=!1;const Q=u(I,V,R);r!==Q&&(r=Q,c(r.object)),$=g(S,I,V,j),$&&_(S,I,V,j),j!==null&&e.update(j,i.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,y(S,R,V,I),j!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(j).buffer))}function l(){return i.createVertexArray()}function c(S){return i.bindVertexArray(S)}function h(S){return i.deleteVertexArray(S)}function u(S,R,V){const I=V.wireframe===!0;let j=n[S.id];j===void 0&&(j={},n[S.id]=j);let $=j[R.id];$===void 0&&($={},j[R.id]=$);let Q=$[I];return Q===void 0&&(Q=f(l()),$[I]=Q),Q}function f(S){const R=[],V=[],I=[];for(let j=0;j<t;j++)R[j]=0,V[j]=0,I[j]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:R,enabledAttributes:V,attributeDivisors:I,object:S,attributes:{},index:null}}function g(S,R,V,I){const j=r.attributes,$=R.attributes;let Q=0;const J=V.getAttributes();for(const ne in J)if(J[ne].location>=0){const he=j[ne];let _e=$[ne];if(_e===void 0&&(ne==="instanceMatrix"&&S.instanceMatrix&&(_e=S.instanceMatrix),ne==="instanceColor"&&S.instanceColor&&(_e=S.instanceColor)),he===void 0||he.attribute!==_e||_e&&he.data!==_e.data)return!0;Q++}return r.attributesNum!==Q||r.index!==I}function _(S,R,V,I){const j={},$=R.attributes;let Q=0;const J=V.getAttributes();for(const ne in J)if(J[ne].location>=0){let he=$[ne];he===void 0&&(ne==="instanceMatrix"&&S.instanceMatrix&&(he=S.instanceMatrix),ne==="instanceColor"&&S.instanceColor&&(he=S.instanceColor));const _e={};_e.attribute=he,he&&he.data&&(_e.data=he.data),j[ne]=_e,Q++}r.attributes=j,r.attributesNum=Q,r.index=I}function v(){const S=r.newAttributes;for(let R=0,V=S.length;R<V;R++)S[R]=0}function p(S){d(S,0)}function d(S,R){const V=r.newAttributes,I=r.enabledAttributes,j=r.attributeDivisors;V[S]=1,I[S]===0&&(i.enableVertexAttribArray(S),I[S]=1),j[S]!==R&&(i.vertexAttribDivisor(S,R),j[S]=R)}function w(){const S=r.newAttributes,R=r.enabledAttributes;for(let V=0,I=R.length;V<I;V++)R[V]!==S[V]&&(i.disableVertexAttribArray(V),R[V]=0)}function T(S,R,V,I,j,$,Q){Q===!0?i.vertexAttribIPointer(S,R,V,j,$):i.vertexAttribPointer(S,R,V,I,j,$)}function y(S,R,V,I){v();const j=I.attributes,$=V.getAttributes(),Q=R.defaultAttributeValues;for(const J in $){const ne=$[J];if(ne.location>=0){let de=j[J];if(de===void 0&&(J==="instanceMatrix"&&S.instanceMatrix&&(de=S.instanceMatrix),J==="instanceColor"&&S.instanceColor&&(de=S.instanceColor)),de!==void 0){const he=de.normalized,_e=de.itemSize,ye=e.get(de);if(ye===void 0)continue;const ge=ye.buffer,re=ye.type,ce=ye.bytesPerElement,ve=re===i.INT||re===i.UNSIGNED_INT||de.gpuType===Xc;if(de.isInterleavedBufferAttribute){const le=de.data,He=le.stride,Ge=de.offset;if(le.isInstancedInterleavedBuffer){for(let Fe=0;Fe<ne.locationSize;Fe++)d(ne.location+Fe,le.meshPerAttribute);S.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=le.meshPerAttribute*le.count)}else for(let Fe=0;Fe<ne.locationSize;Fe++)p(ne.location+Fe);i.bindBuffer(i.ARRAY_BUFFER,ge);for(let Fe=0;Fe<ne.locationSize;Fe++)T(ne.location+Fe,_e/ne.locationSize,re,he,He*ce,(Ge+_e/ne.locationSize*Fe)*ce,ve)}else{if(de.isInstancedBufferAttribute){for(let le=0;le<ne.locationSize;le++)d(ne.location+le,de.meshPerAttribute);S.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=de.meshPerAttribute*de.count)}else for(let le=0;le<ne.locationSize;le++)p(ne.location+le);i.bindBuffer(i.ARRAY_BUFFER,ge);for(let le=0;le<ne.locationSize;le++)T(ne.location+le,_e/ne.locationSize,re,he,_e*ce,_e/ne.locationSize*le*ce,ve)}}else if(Q!==void 0){const he=Q[J];if(he!==void 0)switch(he.length){case 2:i.vertexAttrib2fv(ne.location,he);break;case 3:i.vertexAttrib3fv(ne.location,he);break;case 4:i.vertexAttrib4fv(ne.location,he);break;default:i.vertexAttrib1fv(ne.location,he)}}}}w()}function z(){N();for(const S in n){const R=n[S];for(const V in R){const I=R[V];for(const j in I)h(I[j].object),delete I[j];delete R[V]}delete n[S]}}function L(S){if(n[S.id]===void 0)return;const R=n[S.id];for(const V in R){const I=R[V];for(const j in I)h(I[j].object),delete I[j];delete R[V]}delete n[S.id]}function D(S){for(const R in n){const V=n[R];if(V[S.id]===void 0)continue;const I=V[S.id];for(const j in I)h(I[j].object),delete I[j];delete V[S.id]}}function N(){b(),o=!0,r!==s&&(r=s,c(r.object))}function b(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:N,resetDefaultState:b,dispose:z,releaseStatesOfGeometry:L,releaseStatesOfProgram:D,initAttributes:v,enableAttribute:p,disableUnusedAttributes:w}}function fT(i,e,t){let n;function s(c){n=c}function r(c,h){i.drawArrays(n,c,h),t.update(h,n,1)}function o(c,h,u){u!==0&&(i.drawArraysInstanced(n,c,h,u),t.update(h,n,u))}function a(c,h,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,h,0,u);let g=0;for(let _=0;_<u;_++)g+=h[_];t.update(g,n,1)}function l(c,h,u,f){if(u===0)return;const g=e.get("WEBGL_multi_draw");if(g===null)for(let _=0;_<c.length;_++)o(c[_],h[_],f[_]);else{g.multiDrawArraysInstancedWEBGL(n,c,0,h,0,f,0,u);let _=0;for(let v=0;v<u;v++)_+=h[v]*f[v];t.update(_,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function dT(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){const D=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==si&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){const N=D===lo&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(D!==Oi&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==Di&&!N)}function l(D){if(D==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp";const h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);const u=t.logarithmicDepthBuffer===!0,f=t.reverseDepthBuffer===!0&&e.has("EXT_clip_control"),g=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),d=i.getParameter(i.MAX_VERTEX_ATTRIBS),w=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),y=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),z=_>0,L=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reverseDepthBuffer:f,maxTextures:g,maxVertexTextures:_,maxTextureSize:v,maxCubemapSize:p,maxAttributes:d,maxVertexUniforms:w,maxVaryings:T,maxFragmentUniforms:y,vertexTextures:z,maxSamples:L}}function pT(i){const e=this;let t=null,n=0,s=!1,r=!1;const o=new Zi,a=new et,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){const g=u.length!==0||f||n!==0||s;return s=f,n=u.length,g},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){t=h(u,f,0)},this.setState=function(u,f,g){const _=u.clippingPlanes,v=u.clipIntersection,p=u.clipShadows,d=i.get(u);if(!s||_===null||_.length===0||r&&!p)r?h(null):c();else{const w=r?0:n,T=w*4;let y=d.clippingState||null;l.value=y,y=h(_,f,T,g);for(let z=0;z!==T;++z)y[z]=t[z];d.clippingState=y,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=w}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,f,g,_){const v=u!==null?u.length:0;let p=null;if(v!==0){if(p=l.value,_!==!0||p===null){const d=g+v*4,w=f.matrixWorldInverse;a.getNormalMatrix(w),(p===null||p.length<d)&&(p=new Float32Array(d));for(let T=0,y=g;T!==v;++T,y+=4)o.copy(u[T]).applyMatrix4(w,a),o.normal.toArray(p,y),p[y+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,p}}function mT(i){let e=new WeakMap;function t(o,a){return a===jl?o.mapping=yr:a===Zl&&(o.mapping=Er),o}function n(o){if(o&&o.isTexture){const a=o.mapping;if(a===jl||a===Zl)if(e.has(o)){const l=e.get(o).texture;return t(l,o.mapping)}else{const l=o.image;if(l&&l.height>0){const c=new TE(l.height);return c.fromEquirectangularTexture(i,o),e.set(o,c),o.addEventListener("dispose",s),t(c.texture,o.mapping)}else return null}}return o}function s(o){const a=o.target;a.removeEventListener("dispose",s);const l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function r(){e=new WeakMap}return{get:n,dispose:r}}class qd extends Wd{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}}const ur=4,Gh=[.125,.215,.35,.446,.526,.582],bs=20,vl=new qd,Wh=new at;let xl=null,Ml=0,Sl=0,yl=!1;const Ms=(1+Math.sqrt(5))/2,ar=1/Ms,$h=[new Y(-Ms,ar,0),new Y(Ms,ar,0),new Y(-ar,0,Ms),new Y(ar,0,Ms),new Y(0,Ms,-ar),new Y(0,Ms,ar),new Y(-1,1,-1),new Y(1,1,-1),new Y(-1,1,1),new Y(1,1,1)];class Xh{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,n=.1,s=100){xl=this._renderer.getRenderTarget(),Ml=this._renderer.getActiveCubeFace(),Sl=this._renderer.getActiveMipmapLevel(),yl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);const r=this._allocateTargets();return r.depthBuffer=!0,this._sceneToCubeUV(e,n,s,r),t>0&&this._blur(r,0,0,t),this._applyPMREM(r),this._cleanup(r),r}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Kh(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Yh(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(xl,Ml,Sl),this._renderer.xr.enabled=yl,e.scissorTest=!1,$o(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===yr||e.mapping===Er?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),xl=this._renderer.getRenderTarget(),Ml=this._renderer.getActiveCubeFace(),Sl=this._renderer.getActiveMipmapLevel(),yl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const n=t||this._allocateTargets();return this._textureToCubeUV(e,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){const e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,n={magFilter:_i,minFilter:_i,generateMipmaps:!1,type:lo,format:si,colorSpace:Pr,depthBuffer:!1},s=qh(e,t,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=qh(e,t,n);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=gT(r)),this._blurMaterial=_T(r,e,t)}return s}_compileMaterial(e){const t=new pn(this._lodPlanes[0],e);this._renderer.compile(t,vl)}_sceneToCubeUV(e,t,n,s){const a=new $n(90,1,t,n),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],h=this._renderer,u=h.autoClear,f=h.toneMapping;h.getClearColor(Wh),h.toneMapping=ts,h.autoClear=!1;const g=new eu({name:"PMREM.Background",side:An,depthWrite:!1,depthTest:!1}),_=new pn(new Us,g);let v=!1;const p=e.background;p?p.isColor&&(g.color.copy(p),e.background=null,v=!0):(g.color.copy(Wh),v=!0);for(let d=0;d<6;d++){const w=d%3;w===0?(a.up.set(0,l[d],0),a.lookAt(c[d],0,0)):w===1?(a.up.set(0,0,l[d]),a.lookAt(0,c[d],0)):(a.up.set(0,l[d],0),a.lookAt(0,0,c[d]));const T=this._cubeSize;$o(s,w*T,d>2?T:0,T,T),h.setRenderTarget(s),v&&h.render(_,a),h.render(e,a)}_.geometry.dispose(),_.material.dispose(),h.toneMapping=f,h.autoClear=u,e.background=p}_textureToCubeUV(e,t){const n=this._renderer,s=e.mapping===yr||e.mapping===Er;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=Kh()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Yh());const r=s?this._cubemapMaterial:this._equirectMaterial,o=new pn(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=e;const l=this._cubeSize;$o(t,0,0,3*l,2*l),n.setRenderTarget(t),n.render(o,vl)}_applyPMREM(e){const t=this._renderer,n=t.autoClear;t.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=$h[(s-r-1)%$h.length];this._blur(e,r-1,r,o,a)}t.autoClear=n}_blur(e,t,n,s,r){const o=this._pingPongRenderTarget;this._halfBlur(e,o,t,n,s,"latitudinal",r),this._halfBlur(o,e,n,n,s,"longitudinal",r)}_halfBlur(e,t,n,s,r,o,a){const l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const h=3,u=new pn(this._lodPlanes[s],c),f=c.uniforms,g=this._sizeLods[n]-1,_=isFinite(r)?Math.PI/(2*g):2*Math.PI/(2*bs-1),v=r/_,p=isFinite(r)?1+Math.floor(h*v):bs;p>bs&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${p} samples when the maximum is set to ${bs}`);const d=[];let w=0;for(let D=0;D<bs;++D){const N=D/v,b=Math.exp(-N*N/2);d.push(b),D===0?w+=b:D<p&&(w+=2*b)}for(let D=0;D<d.length;D++)d[D]=d[D]/w;f.envMap.value=e.texture,f.samples.value=p,f.weights.value=d,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);const{_lodMax:T}=this;f.dTheta.value=_,f.mipInt.value=T-n;const y=this._sizeLods[s],z=3*y*(s>T-ur?s-T+ur:0),L=4*(this._cubeSize-y);$o(t,z,L,3*y,2*y),l.setRenderTarget(t),l.render(u,vl)}}function gT(i){const e=[],t=[],n=[];let s=i;const r=i-ur+1+Gh.length;for(let o=0;o<r;o++){const a=Math.pow(2,s);t.push(a);let l=1/a;o>i-ur?l=Gh[o-i+ur-1]:o===0&&(l=0),n.push(l);const c=1/(a-2),h=-c,u=1+c,f=[h,h,u,h,u,u,h,h,u,u,h,u],g=6,_=6,v=3,p=2,d=1,w=new Float32Array(v*_*g),T=new Float32Array(p*_*g),y=new Float32Array(d*_*g);for(let L=0;L<g;L++){const D=L%3*2/3-1,N=L>2?0:-1,b=[D,N,0,D+2/3,N,0,D+2/3,N+1,0,D,N,0,D+2/3,N+1,0,D,N+1,0];w.set(b,v*_*L),T.set(f,p*_*L);const S=[L,L,L,L,L,L];y.set(S,d*_*L)}const z=new Mi;z.setAttribute("position",new vi(w,v)),z.setAttribute("uv",new vi(T,p)),z.setAttribute("faceIndex",new vi(y,d)),e.push(z),s>ur&&s--}return{lodPlanes:e,sizeLods:t,sigmas:n}}function qh(i,e,t){const n=new Ns(i,e,t);return n.texture.mapping=wa,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function $o(i,e,t,n,s){i.viewport.set(e,t,n,s),i.scissor.set(e,t,n,s)}function _T(i,e,t){const n=new Float32Array(bs),s=new Y(0,1,0);return new ss({name:"SphericalGaussianBlur",defines:{n:bs,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:nu(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:es,depthTest:!1,depthWrite:!1})}function Yh(){return new ss({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:nu(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:es,depthTest:!1,depthWrite:!1})}function Kh(){return new ss({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:nu(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:es,depthTest:!1,depthWrite:!1})}function nu(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function vT(i){let e=new WeakMap,t=null;function n(a){if(a&&a.isTexture){const l=a.mapping,c=l===jl||l===Zl,h=l===yr||l===Er;if(c||h){let u=e.get(a);const f=u!==void 0?u.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return t===null&&(t=new Xh(i)),u=c?t.fromEquirectangular(a,u):t.fromCubemap(a,u),u.texture.pmremVersion=a.pmremVersion,e.set(a,u),u.texture;if(u!==void 0)return u.texture;{const g=a.image;return c&&g&&g.height>0||h&&g&&s(g)?(t===null&&(t=new Xh(i)),u=c?t.fromEquirectangular(a):t.fromCubemap(a),u.texture.pmremVersion=a.pmremVersion,e.set(a,u),a.addEventListener("dispose",r),u.texture):null}}}return a}function s(a){let l=0;const c=6;for(let h=0;h<c;h++)a[h]!==void 0&&l++;return l===c}function r(a){const l=a.target;l.removeEventListener("dispose",r);const c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function o(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:n,dispose:o}}function xT(i){const e={};function t(n){if(e[n]!==void 0)return e[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){const s=t(n);return s===null&&Jr("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function MT(i,e,t,n){const s={},r=new WeakMap;function o(u){const f=u.target;f.index!==null&&e.remove(f.index);for(const _ in f.attributes)e.remove(f.attributes[_]);for(const _ in f.morphAttributes){const v=f.morphAttributes[_];for(let p=0,d=v.length;p<d;p++)e.remove(v[p])}f.removeEventListener("dispose",o),delete s[f.id];const g=r.get(f);g&&(e.remove(g),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,t.memory.geometries--}function a(u,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,t.memory.geometries++),f}function l(u){const f=u.attributes;for(const _ in f)e.update(f[_],i.ARRAY_BUFFER);const g=u.morphAttributes;for(const _ in g){const v=g[_];for(let p=0,d=v.length;p<d;p++)e.update(v[p],i.ARRAY_BUFFER)}}function c(u){const f=[],g=u.index,_=u.attributes.position;let v=0;if(g!==null){const w=g.array;v=g.version;for(let T=0,y=w.length;T<y;T+=3){const z=w[T+0],L=w[T+1],D=w[T+2];f.push(z,L,L,D,D,z)}}else if(_!==void 0){const w=_.array;v=_.version;for(let T=0,y=w.length/3-1;T<y;T+=3){const z=T+0,L=T+1,D=T+2;f.push(z,L,L,D,D,z)}}else return;const p=new(Od(f)?Vd:Hd)(f,1);p.version=v;const d=r.get(u);d&&e.remove(d),r.set(u,p)}function h(u){const f=r.get(u);if(f){const g=u.index;g!==null&&f.version<g.version&&c(u)}else c(u);return r.get(u)}return{get:a,update:l,getWireframeAttribute:h}}function ST(i,e,t){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,g){i.drawElements(n,g,r,f*o),t.update(g,n,1)}function c(f,g,_){_!==0&&(i.drawElementsInstanced(n,g,r,f*o,_),t.update(g,n,_))}function h(f,g,_){if(_===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,g,0,r,f,0,_);let p=0;for(let d=0;d<_;d++)p+=g[d];t.update(p,n,1)}function u(f,g,_,v){if(_===0)return;const p=e.get("WEBGL_multi_draw");if(p===null)for(let d=0;d<f.length;d++)c(f[d]/o,g[d],v[d]);else{p.multiDrawElementsInstancedWEBGL(n,g,0,r,f,0,v,0,_);let d=0;for(let w=0;w<_;w++)d+=g[w]*v[w];t.update(d,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=u}function yT(i){const e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function ET(i,e,t){const n=new WeakMap,s=new Gt;function r(o,a,l){const c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0;let f=n.get(a);if(f===void 0||f.count!==u){let S=function(){N.dispose(),n.delete(a),a.removeEventListener("dispose",S)};var g=S;f!==void 0&&f.texture.dispose();const _=a.morphAttributes.position!==void 0,v=a.morphAttributes.normal!==void 0,p=a.morphAttributes.color!==void 0,d=a.morphAttributes.position||[],w=a.morphAttributes.normal||[],T=a.morphAttributes.color||[];let y=0;_===!0&&(y=1),v===!0&&(y=2),p===!0&&(y=3);let z=a.attributes.position.count*y,L=1;z>e.maxTextureSize&&(L=Math.ceil(z/e.maxTextureSize),z=e.maxTextureSize);const D=new Float32Array(z*L*4*u),N=new Bd(D,z,L,u);N.type=Di,N.needsUpdate=!0;const b=y*4;for(let R=0;R<u;R++){const V=d[R],I=w[R],j=T[R],$=z*L*4*R;for(let Q=0;Q<V.count;Q++){const J=Q*b;_===!0&&(s.fromBufferAttribute(V,Q),D[$+J+0]=s.x,D[$+J+1]=s.y,D[$+J+2]=s.z,D[$+J+3]=0),v===!0&&(s.fromBufferAttribute(I,Q),D[$+J+4]=s.x,D[$+J+5]=s.y,D[$+J+6]=s.z,D[$+J+7]=0),p===!0&&(s.fromBufferAttribute(j,Q),D[$+J+8]=s.x,D[$+J+9]=s.y,D[$+J+10]=s.z,D[$+J+11]=j.itemSize===4?s.w:1)}}f={count:u,texture:N,size:new mt(z,L)},n.set(a,f),a.addEventListener("dispose",S)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let _=0;for(let p=0;p<c.length;p++)_+=c[p];const v=a.morphTargetsRelative?1:1-_;l.getUniforms().setValue(i,"morphTargetBaseInfluence",v),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function bT(i,e,t,n){let s=new WeakMap;function r(l){const c=n.render.frame,h=l.geometry,u=e.get(l,h);if(s.get(u)!==c&&(e.update(u),s.set(u,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return u}function o(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:r,dispose:o}}class Yd extends yn{constructor(e,t,n,s,r,o,a,l,c,h=dr){if(h!==dr&&h!==wr)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");n===void 0&&h===dr&&(n=Ds),n===void 0&&h===wr&&(n=br),super(null,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.image={width:e,height:t},this.magFilter=a!==void 0?a:ri,this.minFilter=l!==void 0?l:ri,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.compareFunction=e.compareFunction,this}toJSON(e){const t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}}const Kd=new yn,jh=new Yd(1,1),jd=new Bd,Zd=new uE,Jd=new $d,Zh=[],Jh=[],Qh=new Float32Array(16),ef=new Float32Array(9),tf=new Float32Array(4);function Nr(i,e,t){const n=i[0];if(n<=0||n>0)return i;const s=e*t;let r=Zh[s];if(r===void 0&&(r=new Float32Array(s),Zh[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Qt(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function en(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Ra(i,e){let t=Jh[e];t===void 0&&(t=new Int32Array(e),Jh[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function wT(i,e){const t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function TT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Qt(t,e))return;i.uniform2fv(this.addr,e),en(t,e)}}function AT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Qt(t,e))return;i.uniform3fv(this.addr,e),en(t,e)}}function RT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Qt(t,e))return;i.uniform4fv(this.addr,e),en(t,e)}}function CT(i,e){const t=this.cache,n=e.elements;if(n===void 0){if(Qt(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),en(t,e)}else{if(Qt(t,n))return;tf.set(n),i.uniformMatrix2fv(this.addr,!1,tf),en(t,n)}}function PT(i,e){const t=this.cache,n=e.elements;if(n===void 0){if(Qt(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),en(t,e)}else{if(Qt(t,n))return;ef.set(n),i.uniformMatrix3fv(this.addr,!1,ef),en(t,n)}}function LT(i,e){const t=this.cache,n=e.elements;if(n===void 0){if(Qt(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),en(t,e)}else{if(Qt(t,n))return;Qh.set(n),i.uniformMatrix4fv(this.addr,!1,Qh),en(t,n)}}function DT(i,e){const t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function NT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Qt(t,e))return;i.uniform2iv(this.addr,e),en(t,e)}}function UT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Qt(t,e))return;i.uniform3iv(this.addr,e),en(t,e)}}function IT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Qt(t,e))return;i.uniform4iv(this.addr,e),en(t,e)}}function FT(i,e){const t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function OT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Qt(t,e))return;i.uniform2uiv(this.addr,e),en(t,e)}}function kT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Qt(t,e))return;i.uniform3uiv(this.addr,e),en(t,e)}}function BT(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Qt(t,e))return;i.uniform4uiv(this.addr,e),en(t,e)}}function zT(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(jh.compareFunction=Fd,r=jh):r=Kd,t.setTexture2D(e||r,s)}function HT(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Zd,s)}function VT(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTextureCube(e||Jd,s)}function GT(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||jd,s)}function WT(i){switch(i){case 5126:return wT;case 35664:return TT;case 35665:return AT;case 35666:return RT;case 35674:return CT;case 35675:return PT;case 35676:return LT;case 5124:case 35670:return DT;case 35667:case 35671:return NT;case 35668:case 35672:return UT;case 35669:case 35673:return IT;case 5125:return FT;case 36294:return OT;case 36295:return kT;case 36296:return BT;case 35678:case 36198:case 36298:case 36306:case 35682:return zT;case 35679:case 36299:case 36307:return HT;case 35680:case 36300:case 36308:case 36293:return VT;case 36289:case 36303:case 36311:case 36292:return GT}}function $T(i,e){i.uniform1fv(this.addr,e)}function XT(i,e){const t=Nr(e,this.size,2);i.uniform2fv(this.addr,t)}function qT(i,e){const t=Nr(e,this.size,3);i.uniform3fv(this.addr,t)}function YT(i,e){const t=Nr(e,this.size,4);i.uniform4fv(this.addr,t)}function KT(i,e){const t=Nr(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function jT(i,e){const t=Nr(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function ZT(i,e){const t=Nr(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function JT(i,e){i.uniform1iv(this.addr,e)}function QT(i,e){i.uniform2iv(this.addr,e)}function e1(i,e){i.uniform3iv(this.addr,e)}function t1(i,e){i.uniform4iv(this.addr,e)}function n1(i,e){i.uniform1uiv(this.addr,e)}function i1(i,e){i.uniform2uiv(this.addr,e)}function s1(i,e){i.uniform3uiv(this.addr,e)}function r1(i,e){i.uniform4uiv(this.addr,e)}function o1(i,e,t){const n=this.cache,s=e.length,r=Ra(t,s);Qt(n,r)||(i.uniform1iv(this.addr,r),en(n,r));for(let o=0;o!==s;++o)t.setTexture2D(e[o]||Kd,r[o])}function a1(i,e,t){const n=this.cache,s=e.length,r=Ra(t,s);Qt(n,r)||(i.uniform1iv(this.addr,r),en(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Zd,r[o])}function l1(i,e,t){const n=this.cache,s=e.length,r=Ra(t,s);Qt(n,r)||(i.uniform1iv(this.addr,r),en(n,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||Jd,r[o])}function c1(i,e,t){const n=this.cache,s=e.length,r=Ra(t,s);Qt(n,r)||(i.uniform1iv(this.addr,r),en(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||jd,r[o])}function u1(i){switch(i){case 5126:return $T;case 35664:return XT;case 35665:return qT;case 35666:return YT;case 35674:return KT;case 35675:return jT;case 35676:return ZT;case 5124:case 35670:return JT;case 35667:case 35671:return QT;case 35668:case 35672:return e1;case 35669:case 35673:return t1;case 5125:return n1;case 36294:return i1;case 36295:return s1;case 36296:return r1;case 35678:case 36198:case 36298:case 36306:case 35682:return o1;case 35679:case 36299:case 36307:return a1;case 35680:case 36300:case 36308:case 36293:return l1;case 36289:case 36303:case 36311:case 36292:return c1}}class h1{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=WT(t.type)}}class f1{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=u1(t.type)}}class d1{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(e,t[a.id],n)}}}const El=/(\w+)(\])?(\[|\.)?/g;function nf(i,e){i.seq.push(e),i.map[e.id]=e}function p1(i,e,t){const n=i.name,s=n.length;for(El.lastIndex=0;;){const r=El.exec(n),o=El.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){nf(t,c===void 0?new h1(a,i,e):new f1(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new d1(a),nf(t,u)),t=u}}}class na{constructor(e,t){this.seq=[],this.map={};const n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){const r=e.getActiveUniform(t,s),o=e.getUniformLocation(t,r.name);p1(r,o,this)}}setValue(e,t,n,s){const r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){const s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){const a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){const n=[];for(let s=0,r=e.length;s!==r;++s){const o=e[s];o.id in t&&n.push(o)}return n}}function sf(i,e,t){const n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}const m1=37297;let g1=0;function _1(i,e){const t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){const a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}const rf=new et;function v1(i){pt._getMatrix(rf,pt.workingColorSpace,i);const e=`mat3( ${rf.elements.map(t=>t.toFixed(4))} )`;switch(pt.getTransfer(i)){case Ta:return[e,"LinearTransferOETF"];case At:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function of(i,e,t){const n=i.getShaderParameter(e,i.COMPILE_STATUS),s=i.getShaderInfoLog(e).trim();if(n&&s==="")return"";const r=/ERROR: 0:(\d+)/.exec(s);if(r){const o=parseInt(r[1]);return t.toUpperCase()+`

`+s+`

`+_1(i.getShaderSource(e),o)}else return s}function x1(i,e){const t=v1(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function M1(i,e){let t;switch(e){case Oy:t="Linear";break;case ky:t="Reinhard";break;case By:t="Cineon";break;case zy:t="ACESFilmic";break;case Vy:t="AgX";break;case Gy:t="Neutral";break;case Hy:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}const Xo=new Y;function S1(){pt.getLuminanceCoefficients(Xo);const i=Xo.x.toFixed(4),e=Xo.y.toFixed(4),t=Xo.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function y1(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Qr).join(`
`)}function E1(i){const e=[];for(const t in i){const n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function b1(i,e){const t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){const r=i.getActiveAttrib(e,s),o=r.name;let a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Qr(i){return i!==""}function af(i,e){const t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function lf(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}const w1=/^[ \t]*#include +<([\w\d./]+)>/gm;function Tc(i){return i.replace(w1,A1)}const T1=new Map;function A1(i,e){let t=nt[e];if(t===void 0){const n=T1.get(e);if(n!==void 0)t=nt[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,n);else throw new Error("Can not resolve #include <"+e+">")}return Tc(t)}const R1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function cf(i){return i.replace(R1,C1)}function C1(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function uf(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}function P1(i){let e="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===Sd?e="SHADOWMAP_TYPE_PCF":i.shadowMapType===yd?e="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Pi&&(e="SHADOWMAP_TYPE_VSM"),e}function L1(i){let e="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case yr:case Er:e="ENVMAP_TYPE_CUBE";break;case wa:e="ENVMAP_TYPE_CUBE_UV";break}return e}function D1(i){let e="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case Er:e="ENVMAP_MODE_REFRACTION";break}return e}function N1(i){let e="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case Ed:e="ENVMAP_BLENDING_MULTIPLY";break;case Iy:e="ENVMAP_BLENDING_MIX";break;case Fy:e="ENVMAP_BLENDING_ADD";break}return e}function U1(i){const e=i.envMapCubeUVHeight;if(e===null)return null;const t=Math.log2(e)-2,n=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:n,maxMip:t}}function I1(i,e,t,n){const s=i.getContext(),r=t.defines;let o=t.vertexShader,a=t.fragmentShader;const l=P1(t),c=L1(t),h=D1(t),u=N1(t),f=U1(t),g=y1(t),_=E1(r),v=s.createProgram();let p,d,w=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(Qr).join(`
`),p.length>0&&(p+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(Qr).join(`
`),d.length>0&&(d+=`
`)):(p=[uf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",t.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Qr).join(`
`),d=[uf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",t.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ts?"#define TONE_MAPPING":"",t.toneMapping!==ts?nt.tonemapping_pars_fragment:"",t.toneMapping!==ts?M1("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",nt.colorspace_pars_fragment,x1("linearToOutputTexel",t.outputColorSpace),S1(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Qr).join(`
`)),o=Tc(o),o=af(o,t),o=lf(o,t),a=Tc(a),a=af(a,t),a=lf(a,t),o=cf(o),a=cf(a),t.isRawShaderMaterial!==!0&&(w=`#version 300 es
`,p=[g,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+p,d=["#define varying in",t.glslVersion===yh?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===yh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);const T=w+p+o,y=w+d+a,z=sf(s,s.VERTEX_SHADER,T),L=sf(s,s.FRAGMENT_SHADER,y);s.attachShader(v,z),s.attachShader(v,L),t.index0AttributeName!==void 0?s.bindAttribLocation(v,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function D(R){if(i.debug.checkShaderErrors){const V=s.getProgramInfoLog(v).trim(),I=s.getShaderInfoLog(z).trim(),j=s.getShaderInfoLog(L).trim();let $=!0,Q=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if($=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,v,z,L);else{const J=of(s,z,"vertex"),ne=of(s,L,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+V+`
`+J+`
`+ne)}else V!==""?console.warn("THREE.WebGLProgram: Program Info Log:",V):(I===""||j==="")&&(Q=!1);Q&&(R.diagnostics={runnable:$,programLog:V,vertexShader:{log:I,prefix:p},fragmentShader:{log:j,prefix:d}})}s.deleteShader(z),s.deleteShader(L),N=new na(s,v),b=b1(s,v)}let N;this.getUniforms=function(){return N===void 0&&D(this),N};let b;this.getAttributes=function(){return b===void 0&&D(this),b};let S=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(v,m1)),S},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=g1++,this.cacheKey=e,this.usedTimes=1,this.program=v,this.vertexShader=z,this.fragmentShader=L,this}let F1=0;class O1{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){const t=e.vertexShader,n=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){const t=this.materialCache.get(e);for(const n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){const t=this.materialCache;let n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){const t=this.shaderCache;let n=t.get(e);return n===void 0&&(n=new k1(e),t.set(e,n)),n}}class k1{constructor(e){this.id=F1++,this.code=e,this.usedTimes=0}}function B1(i,e,t,n,s,r,o){const a=new Qc,l=new O1,c=new Set,h=[],u=s.logarithmicDepthBuffer,f=s.vertexTextures;let g=s.precision;const _={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(b){return c.add(b),b===0?"uv":`uv${b}`}function p(b,S,R,V,I){const j=V.fog,$=I.geometry,Q=b.isMeshStandardMaterial?V.environment:null,J=(b.isMeshStandardMaterial?t:e).get(b.envMap||Q),ne=J&&J.mapping===wa?J.image.height:null,de=_[b.type];b.precision!==null&&(g=s.getMaxPrecision(b.precision),g!==b.precision&&console.warn("THREE.WebGLProgram.getParameters:",b.precision,"not supported, using",g,"instead."));const he=$.morphAttributes.position||$.morphAttributes.normal||$.morphAttributes.color,_e=he!==void 0?he.length:0;let ye=0;$.morphAttributes.position!==void 0&&(ye=1),$.morphAttributes.normal!==void 0&&(ye=2),$.morphAttributes.color!==void 0&&(ye=3);let ge,re,ce,ve;if(de){const vt=mi[de];ge=vt.vertexShader,re=vt.fragmentShader}else ge=b.vertexShader,re=b.fragmentShader,l.update(b),ce=l.getVertexShaderID(b),ve=l.getFragmentShaderID(b);const le=i.getRenderTarget(),He=i.state.buffers.depth.getReversed(),Ge=I.isInstancedMesh===!0,Fe=I.isBatchedMesh===!0,lt=!!b.map,Ze=!!b.matcap,ct=!!J,k=!!b.aoMap,Yt=!!b.lightMap,Qe=!!b.bumpMap,tt=!!b.normalMap,We=!!b.displacementMap,ht=!!b.emissiveMap,De=!!b.metalnessMap,C=!!b.roughnessMap,M=b.anisotropy>0,Z=b.clearcoat>0,ee=b.dispersion>0,G=b.iridescence>0,ie=b.sheen>0,Ee=b.transmission>0,xe=M&&!!b.anisotropyMap,Ae=Z&&!!b.clearcoatMap,je=Z&&!!b.clearcoatNormalMap,pe=Z&&!!b.clearcoatRoughnessMap,Me=G&&!!b.iridescenceMap,Oe=G&&!!b.iridescenceThicknessMap,Be=ie&&!!b.sheenColorMap,we=ie&&!!b.sheenRoughnessMap,it=!!b.specularMap,Ye=!!b.specularColorMap,ft=!!b.specularIntensityMap,O=Ee&&!!b.transmissionMap,Se=Ee&&!!b.thicknessMap,se=!!b.gradientMap,ae=!!b.alphaMap,Re=b.alphaTest>0,Ce=!!b.alphaHash,Je=!!b.extensions;let Ft=ts;b.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Ft=i.toneMapping);const tn={shaderID:de,shaderType:b.type,shaderName:b.name,vertexShader:ge,fragmentShader:re,defines:b.defines,customVertexShaderID:ce,customFragmentShaderID:ve,isRawShaderMaterial:b.isRawShaderMaterial===!0,glslVersion:b.glslVersion,precision:g,batching:Fe,batchingColor:Fe&&I._colorsTexture!==null,instancing:Ge,instancingColor:Ge&&I.instanceColor!==null,instancingMorph:Ge&&I.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:le===null?i.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:Pr,alphaToCoverage:!!b.alphaToCoverage,map:lt,matcap:Ze,envMap:ct,envMapMode:ct&&J.mapping,envMapCubeUVHeight:ne,aoMap:k,lightMap:Yt,bumpMap:Qe,normalMap:tt,displacementMap:f&&We,emissiveMap:ht,normalMapObjectSpace:tt&&b.normalMapType===qy,normalMapTangentSpace:tt&&b.normalMapType===Id,metalnessMap:De,roughnessMap:C,anisotropy:M,anisotropyMap:xe,clearcoat:Z,clearcoatMap:Ae,clearcoatNormalMap:je,clearcoatRoughnessMap:pe,dispersion:ee,iridescence:G,iridescenceMap:Me,iridescenceThicknessMap:Oe,sheen:ie,sheenColorMap:Be,sheenRoughnessMap:we,specularMap:it,specularColorMap:Ye,specularIntensityMap:ft,transmission:Ee,transmissionMap:O,thicknessMap:Se,gradientMap:se,opaque:b.transparent===!1&&b.blending===fr&&b.alphaToCoverage===!1,alphaMap:ae,alphaTest:Re,alphaHash:Ce,combine:b.combine,mapUv:lt&&v(b.map.channel),aoMapUv:k&&v(b.aoMap.channel),lightMapUv:Yt&&v(b.lightMap.channel),bumpMapUv:Qe&&v(b.bumpMap.channel),normalMapUv:tt&&v(b.normalMap.channel),displacementMapUv:We&&v(b.displacementMap.channel),emissiveMapUv:ht&&v(b.emissiveMap.channel),metalnessMapUv:De&&v(b.metalnessMap.channel),roughnessMapUv:C&&v(b.roughnessMap.channel),anisotropyMapUv:xe&&v(b.anisotropyMap.channel),clearcoatMapUv:Ae&&v(b.clearcoatMap.channel),clearcoatNormalMapUv:je&&v(b.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:pe&&v(b.clearcoatRoughnessMap.channel),iridescenceMapUv:Me&&v(b.iridescenceMap.channel),iridescenceThicknessMapUv:Oe&&v(b.iridescenceThicknessMap.channel),sheenColorMapUv:Be&&v(b.sheenColorMap.channel),sheenRoughnessMapUv:we&&v(b.sheenRoughnessMap.channel),specularMapUv:it&&v(b.specularMap.channel),specularColorMapUv:Ye&&v(b.specularColorMap.channel),specularIntensityMapUv:ft&&v(b.specularIntensityMap.channel),transmissionMapUv:O&&v(b.transmissionMap.channel),thicknessMapUv:Se&&v(b.thicknessMap.channel),alphaMapUv:ae&&v(b.alphaMap.channel),vertexTangents:!!$.attributes.tangent&&(tt||M),vertexColors:b.vertexColors,vertexAlphas:b.vertexColors===!0&&!!$.attributes.color&&$.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!$.attributes.uv&&(lt||ae),fog:!!j,useFog:b.fog===!0,fogExp2:!!j&&j.isFogExp2,flatShading:b.flatShading===!0,sizeAttenuation:b.sizeAttenuation===!0,logarithmicDepthBuffer:u,reverseDepthBuffer:He,skinning:I.isSkinnedMesh===!0,morphTargets:$.morphAttributes.position!==void 0,morphNormals:$.morphAttributes.normal!==void 0,morphColors:$.morphAttributes.color!==void 0,morphTargetsCount:_e,morphTextureStride:ye,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:b.dithering,shadowMapEnabled:i.shadowMap.enabled&&R.length>0,shadowMapType:i.shadowMap.type,toneMapping:Ft,decodeVideoTexture:lt&&b.map.isVideoTexture===!0&&pt.getTransfer(b.map.colorSpace)===At,decodeVideoTextureEmissive:ht&&b.emissiveMap.isVideoTexture===!0&&pt.getTransfer(b.emissiveMap.colorSpace)===At,premultipliedAlpha:b.premultipliedAlpha,doubleSided:b.side===Li,flipSided:b.side===An,useDepthPacking:b.depthPacking>=0,depthPacking:b.depthPacking||0,index0AttributeName:b.index0AttributeName,extensionClipCullDistance:Je&&b.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&b.extensions.multiDraw===!0||Fe)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:b.customProgramCacheKey()};return tn.vertexUv1s=c.has(1),tn.vertexUv2s=c.has(2),tn.vertexUv3s=c.has(3),c.clear(),tn}function d(b){const S=[];if(b.shaderID?S.push(b.shaderID):(S.push(b.customVertexShaderID),S.push(b.customFragmentShaderID)),b.defines!==void 0)for(const R in b.defines)S.push(R),S.push(b.defines[R]);return b.isRawShaderMaterial===!1&&(w(S,b),T(S,b),S.push(i.outputColorSpace)),S.push(b.customProgramCacheKey),S.join()}function w(b,S){b.push(S.precision),b.push(S.outputColorSpace),b.push(S.envMapMode),b.push(S.envMapCubeUVHeight),b.push(S.mapUv),b.push(S.alphaMapUv),b.push(S.lightMapUv),b.push(S.aoMapUv),b.push(S.bumpMapUv),b.push(S.normalMapUv),b.push(S.displacementMapUv),b.push(S.emissiveMapUv),b.push(S.metalnessMapUv),b.push(S.roughnessMapUv),b.push(S.anisotropyMapUv),b.push(S.clearcoatMapUv),b.push(S.clearcoatNormalMapUv),b.push(S.clearcoatRoughnessMapUv),b.push(S.iridescenceMapUv),b.push(S.iridescenceThicknessMapUv),b.push(S.sheenColorMapUv),b.push(S.sheenRoughnessMapUv),b.push(S.specularMapUv),b.push(S.specularColorMapUv),b.push(S.specularIntensityMapUv),b.push(S.transmissionMapUv),b.push(S.thicknessMapUv),b.push(S.combine),b.push(S.fogExp2),b.push(S.sizeAttenuation),b.push(S.morphTargetsCount),b.push(S.morphAttributeCount),b.push(S.numDirLights),b.push(S.numPointLights),b.push(S.numSpotLights),b.push(S.numSpotLightMaps),b.push(S.numHemiLights),b.push(S.numRectAreaLights),b.push(S.numDirLightShadows),b.push(S.numPointLightShadows),b.push(S.numSpotLightShadows),b.push(S.numSpotLightShadowsWithMaps),b.push(S.numLightProbes),b.push(S.shadowMapType),b.push(S.toneMapping),b.push(S.numClippingPlanes),b.push(S.numClipIntersection),b.push(S.depthPacking)}function T(b,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),b.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reverseDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),b.push(a.mask)}function y(b){const S=_[b.type];let R;if(S){const V=mi[S];R=yE.clone(V.uniforms)}else R=b.uniforms;return R}function z(b,S){let R;for(let V=0,I=h.length;V<I;V++){const j=h[V];if(j.cacheKey===S){R=j,++R.usedTimes;break}}return R===void 0&&(R=new I1(i,S,b,r),h.push(R)),R}function L(b){if(--b.usedTimes===0){const S=h.indexOf(b);h[S]=h[h.length-1],h.pop(),b.destroy()}}function D(b){l.remove(b)}function N(){l.dispose()}return{getParameters:p,getProgramCacheKey:d,getUniforms:y,acquireProgram:z,releaseProgram:L,releaseShaderCache:D,programs:h,dispose:N}}function z1(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function H1(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.z!==e.z?i.z-e.z:i.id-e.id}function hf(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function ff(){const i=[];let e=0;const t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(u,f,g,_,v,p){let d=i[e];return d===void 0?(d={id:u.id,object:u,geometry:f,material:g,groupOrder:_,renderOrder:u.renderOrder,z:v,group:p},i[e]=d):(d.id=u.id,d.object=u,d.geometry=f,d.material=g,d.groupOrder=_,d.renderOrder=u.renderOrder,d.z=v,d.group=p),e++,d}function a(u,f,g,_,v,p){const d=o(u,f,g,_,v,p);g.transmission>0?n.push(d):g.transparent===!0?s.push(d):t.push(d)}function l(u,f,g,_,v,p){const d=o(u,f,g,_,v,p);g.transmission>0?n.unshift(d):g.transparent===!0?s.unshift(d):t.unshift(d)}function c(u,f){t.length>1&&t.sort(u||H1),n.length>1&&n.sort(f||hf),s.length>1&&s.sort(f||hf)}function h(){for(let u=e,f=i.length;u<f;u++){const g=i[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:h,sort:c}}function V1(){let i=new WeakMap;function e(n,s){const r=i.get(n);let o;return r===void 0?(o=new ff,i.set(n,[o])):s>=r.length?(o=new ff,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function G1(){const i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new Y,color:new at};break;case"SpotLight":t={position:new Y,direction:new Y,color:new at,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new Y,color:new at,distance:0,decay:0};break;case"HemisphereLight":t={direction:new Y,skyColor:new at,groundColor:new at};break;case"RectAreaLight":t={color:new at,position:new Y,halfWidth:new Y,halfHeight:new Y};break}return i[e.id]=t,t}}}function W1(){const i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new mt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new mt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new mt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}let $1=0;function X1(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function q1(i){const e=new G1,t=W1(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new Y);const s=new Y,r=new Bt,o=new Bt;function a(c){let h=0,u=0,f=0;for(let b=0;b<9;b++)n.probe[b].set(0,0,0);let g=0,_=0,v=0,p=0,d=0,w=0,T=0,y=0,z=0,L=0,D=0;c.sort(X1);for(let b=0,S=c.length;b<S;b++){const R=c[b],V=R.color,I=R.intensity,j=R.distance,$=R.shadow&&R.shadow.map?R.shadow.map.texture:null;if(R.isAmbientLight)h+=V.r*I,u+=V.g*I,f+=V.b*I;else if(R.isLightProbe){for(let Q=0;Q<9;Q++)n.probe[Q].addScaledVector(R.sh.coefficients[Q],I);D++}else if(R.isDirectionalLight){const Q=e.get(R);if(Q.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){const J=R.shadow,ne=t.get(R);ne.shadowIntensity=J.intensity,ne.shadowBias=J.bias,ne.shadowNormalBias=J.normalBias,ne.shadowRadius=J.radius,ne.shadowMapSize=J.mapSize,n.directionalShadow[g]=ne,n.directionalShadowMap[g]=$,n.directionalShadowMatrix[g]=R.shadow.matrix,w++}n.directional[g]=Q,g++}else if(R.isSpotLight){const Q=e.get(R);Q.position.setFromMatrixPosition(R.matrixWorld),Q.color.copy(V).multiplyScalar(I),Q.distance=j,Q.coneCos=Math.cos(R.angle),Q.penumbraCos=Math.cos(R.angle*(1-R.penumbra)),Q.decay=R.decay,n.spot[v]=Q;const J=R.shadow;if(R.map&&(n.spotLightMap[z]=R.map,z++,J.updateMatrices(R),R.castShadow&&L++),n.spotLightMatrix[v]=J.matrix,R.castShadow){const ne=t.get(R);ne.shadowIntensity=J.intensity,ne.shadowBias=J.bias,ne.shadowNormalBias=J.normalBias,ne.shadowRadius=J.radius,ne.shadowMapSize=J.mapSize,n.spotShadow[v]=ne,n.spotShadowMap[v]=$,y++}v++}else if(R.isRectAreaLight){const Q=e.get(R);Q.color.copy(V).multiplyScalar(I),Q.halfWidth.set(R.width*.5,0,0),Q.halfHeight.set(0,R.height*.5,0),n.rectArea[p]=Q,p++}else if(R.isPointLight){const Q=e.get(R);if(Q.color.copy(R.color).multiplyScalar(R.intensity),Q.distance=R.distance,Q.decay=R.decay,R.castShadow){const J=R.shadow,ne=t.get(R);ne.shadowIntensity=J.intensity,ne.shadowBias=J.bias,ne.shadowNormalBias=J.normalBias,ne.shadowRadius=J.radius,ne.shadowMapSize=J.mapSize,ne.shadowCameraNear=J.camera.near,ne.shadowCameraFar=J.camera.far,n.pointShadow[_]=ne,n.pointShadowMap[_]=$,n.pointShadowMatrix[_]=R.shadow.matrix,T++}n.point[_]=Q,_++}else if(R.isHemisphereLight){const Q=e.get(R);Q.skyColor.copy(R.color).multiplyScalar(I),Q.groundColor.copy(R.groundColor).multiplyScalar(I),n.hemi[d]=Q,d++}}p>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Te.LTC_FLOAT_1,n.rectAreaLTC2=Te.LTC_FLOAT_2):(n.rectAreaLTC1=Te.LTC_HALF_1,n.rectAreaLTC2=Te.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=f;const N=n.hash;(N.directionalLength!==g||N.pointLength!==_||N.spotLength!==v||N.rectAreaLength!==p||N.hemiLength!==d||N.numDirectionalShadows!==w||N.numPointShadows!==T||N.numSpotShadows!==y||N.numSpotMaps!==z||N.numLightProbes!==D)&&(n.directional.length=g,n.spot.length=v,n.rectArea.length=p,n.point.length=_,n.hemi.length=d,n.directionalShadow.length=w,n.directionalShadowMap.length=w,n.pointShadow.length=T,n.pointShadowMap.length=T,n.spotShadow.length=y,n.spotShadowMap.length=y,n.directionalShadowMatrix.length=w,n.pointShadowMatrix.length=T,n.spotLightMatrix.length=y+z-L,n.spotLightMap.length=z,n.numSpotLightShadowsWithMaps=L,n.numLightProbes=D,N.directionalLength=g,N.pointLength=_,N.spotLength=v,N.rectAreaLength=p,N.hemiLength=d,N.numDirectionalShadows=w,N.numPointShadows=T,N.numSpotShadows=y,N.numSpotMaps=z,N.numLightProbes=D,n.version=$1++)}function l(c,h){let u=0,f=0,g=0,_=0,v=0;const p=h.matrixWorldInverse;for(let d=0,w=c.length;d<w;d++){const T=c[d];if(T.isDirectionalLight){const y=n.directional[u];y.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(p),u++}else if(T.isSpotLight){const y=n.spot[g];y.position.setFromMatrixPosition(T.matrixWorld),y.position.applyMatrix4(p),y.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(p),g++}else if(T.isRectAreaLight){const y=n.rectArea[_];y.position.setFromMatrixPosition(T.matrixWorld),y.position.applyMatrix4(p),o.identity(),r.copy(T.matrixWorld),r.premultiply(p),o.extractRotation(r),y.halfWidth.set(T.width*.5,0,0),y.halfHeight.set(0,T.height*.5,0),y.halfWidth.applyMatrix4(o),y.halfHeight.applyMatrix4(o),_++}else if(T.isPointLight){const y=n.point[f];y.position.setFromMatrixPosition(T.matrixWorld),y.position.applyMatrix4(p),f++}else if(T.isHemisphereLight){const y=n.hemi[v];y.direction.setFromMatrixPosition(T.matrixWorld),y.direction.transformDirection(p),v++}}}return{setup:a,setupView:l,state:n}}function df(i){const e=new q1(i),t=[],n=[];function s(h){c.camera=h,t.length=0,n.length=0}function r(h){t.push(h)}function o(h){n.push(h)}function a(){e.setup(t)}function l(h){e.setupView(t,h)}const c={lightsArray:t,shadowsArray:n,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function Y1(i){let e=new WeakMap;function t(s,r=0){const o=e.get(s);let a;return o===void 0?(a=new df(i),e.set(s,[a])):r>=o.length?(a=new df(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}class K1 extends Dr{static get type(){return"MeshDepthMaterial"}constructor(e){super(),this.isMeshDepthMaterial=!0,this.depthPacking=$y,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}}class j1 extends Dr{static get type(){return"MeshDistanceMaterial"}constructor(e){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}}const Z1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,J1=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function Q1(i,e,t){let n=new tu;const s=new mt,r=new mt,o=new Gt,a=new K1({depthPacking:Xy}),l=new j1,c={},h=t.maxTextureSize,u={[is]:An,[An]:is,[Li]:Li},f=new ss({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new mt},radius:{value:4}},vertexShader:Z1,fragmentShader:J1}),g=f.clone();g.defines.HORIZONTAL_PASS=1;const _=new Mi;_.setAttribute("position",new vi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const v=new pn(_,f),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Sd;let d=this.type;this.render=function(L,D,N){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||L.length===0)return;const b=i.getRenderTarget(),S=i.getActiveCubeFace(),R=i.getActiveMipmapLevel(),V=i.state;V.setBlending(es),V.buffers.color.setClear(1,1,1,1),V.buffers.depth.setTest(!0),V.setScissorTest(!1);const I=d!==Pi&&this.type===Pi,j=d===Pi&&this.type!==Pi;for(let $=0,Q=L.length;$<Q;$++){const J=L[$],ne=J.shadow;if(ne===void 0){console.warn("THREE.WebGLShadowMap:",J,"has no shadow.");continue}if(ne.autoUpdate===!1&&ne.needsUpdate===!1)continue;s.copy(ne.mapSize);const de=ne.getFrameExtents();if(s.multiply(de),r.copy(ne.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/de.x),s.x=r.x*de.x,ne.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/de.y),s.y=r.y*de.y,ne.mapSize.y=r.y)),ne.map===null||I===!0||j===!0){const _e=this.type!==Pi?{minFilter:ri,magFilter:ri}:{};ne.map!==null&&ne.map.dispose(),ne.map=new Ns(s.x,s.y,_e),ne.map.texture.name=J.name+".shadowMap",ne.camera.updateProjectionMatrix()}i.setRenderTarget(ne.map),i.clear();const he=ne.getViewportCount();for(let _e=0;_e<he;_e++){const ye=ne.getViewport(_e);o.set(r.x*ye.x,r.y*ye.y,r.x*ye.z,r.y*ye.w),V.viewport(o),ne.updateMatrices(J,_e),n=ne.getFrustum(),y(D,N,ne.camera,J,this.type)}ne.isPointLightShadow!==!0&&this.type===Pi&&w(ne,N),ne.needsUpdate=!1}d=this.type,p.needsUpdate=!1,i.setRenderTarget(b,S,R)};function w(L,D){const N=e.update(v);f.defines.VSM_SAMPLES!==L.blurSamples&&(f.defines.VSM_SAMPLES=L.blurSamples,g.defines.VSM_SAMPLES=L.blurSamples,f.needsUpdate=!0,g.needsUpdate=!0),L.mapPass===null&&(L.mapPass=new Ns(s.x,s.y)),f.uniforms.shadow_pass.value=L.map.texture,f.uniforms.resolution.value=L.mapSize,f.uniforms.radius.value=L.radius,i.setRenderTarget(L.mapPass),i.clear(),i.renderBufferDirect(D,null,N,f,v,null),g.uniforms.shadow_pass.value=L.mapPass.texture,g.uniforms.resolution.value=L.mapSize,g.uniforms.radius.value=L.radius,i.setRenderTarget(L.map),i.clear(),i.renderBufferDirect(D,null,N,g,v,null)}function T(L,D,N,b){let S=null;const R=N.isPointLight===!0?L.customDistanceMaterial:L.customDepthMaterial;if(R!==void 0)S=R;else if(S=N.isPointLight===!0?l:a,i.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0){const V=S.uuid,I=D.uuid;let j=c[V];j===void 0&&(j={},c[V]=j);let $=j[I];$===void 0&&($=S.clone(),j[I]=$,D.addEventListener("dispose",z)),S=$}if(S.visible=D.visible,S.wireframe=D.wireframe,b===Pi?S.side=D.shadowSide!==null?D.shadowSide:D.side:S.side=D.shadowSide!==null?D.shadowSide:u[D.side],S.alphaMap=D.alphaMap,S.alphaTest=D.alphaTest,S.map=D.map,S.clipShadows=D.clipShadows,S.clippingPlanes=D.clippingPlanes,S.clipIntersection=D.clipIntersection,S.displacementMap=D.displacementMap,S.displacementScale=D.displacementScale,S.displacementBias=D.displacementBias,S.wireframeLinewidth=D.wireframeLinewidth,S.linewidth=D.linewidth,N.isPointLight===!0&&S.isMeshDistanceMaterial===!0){const V=i.properties.get(S);V.light=N}return S}function y(L,D,N,b,S){if(L.visible===!1)return;if(L.layers.test(D.layers)&&(L.isMesh||L.isLine||L.isPoints)&&(L.castShadow||L.receiveShadow&&S===Pi)&&(!L.frustumCulled||n.intersectsObject(L))){L.modelViewMatrix.multiplyMatrices(N.matrixWorldInverse,L.matrixWorld);const I=e.update(L),j=L.material;if(Array.isArray(j)){const $=I.groups;for(let Q=0,J=$.length;Q<J;Q++){const ne=$[Q],de=j[ne.materialIndex];if(de&&de.visible){const he=T(L,de,b,S);L.onBeforeShadow(i,L,D,N,I,he,ne),i.renderBufferDirect(N,null,I,he,L,ne),L.onAfterShadow(i,L,D,N,I,he,ne)}}}else if(j.visible){const $=T(L,j,b,S);L.onBeforeShadow(i,L,D,N,I,$,null),i.renderBufferDirect(N,null,I,$,L,null),L.onAfterShadow(i,L,D,N,I,$,null)}}const V=L.children;for(let I=0,j=V.length;I<j;I++)y(V[I],D,N,b,S)}function z(L){L.target.removeEventListener("dispose",z);for(const N in c){const b=c[N],S=L.target.uuid;S in b&&(b[S].dispose(),delete b[S])}}}const eA={[Gl]:Wl,[$l]:Yl,[Xl]:Kl,[Sr]:ql,[Wl]:Gl,[Yl]:$l,[Kl]:Xl,[ql]:Sr};function tA(i,e){function t(){let O=!1;const Se=new Gt;let se=null;const ae=new Gt(0,0,0,0);return{setMask:function(Re){se!==Re&&!O&&(i.colorMask(Re,Re,Re,Re),se=Re)},setLocked:function(Re){O=Re},setClear:function(Re,Ce,Je,Ft,tn){tn===!0&&(Re*=Ft,Ce*=Ft,Je*=Ft),Se.set(Re,Ce,Je,Ft),ae.equals(Se)===!1&&(i.clearColor(Re,Ce,Je,Ft),ae.copy(Se))},reset:function(){O=!1,se=null,ae.set(-1,0,0,0)}}}function n(){let O=!1,Se=!1,se=null,ae=null,Re=null;return{setReversed:function(Ce){if(Se!==Ce){const Je=e.get("EXT_clip_control");Se?Je.clipControlEXT(Je.LOWER_LEFT_EXT,Je.ZERO_TO_ONE_EXT):Je.clipControlEXT(Je.LOWER_LEFT_EXT,Je.NEGATIVE_ONE_TO_ONE_EXT);const Ft=Re;Re=null,this.setClear(Ft)}Se=Ce},getReversed:function(){return Se},setTest:function(Ce){Ce?le(i.DEPTH_TEST):He(i.DEPTH_TEST)},setMask:function(Ce){se!==Ce&&!O&&(i.depthMask(Ce),se=Ce)},setFunc:function(Ce){if(Se&&(Ce=eA[Ce]),ae!==Ce){switch(Ce){case Gl:i.depthFunc(i.NEVER);break;case Wl:i.depthFunc(i.ALWAYS);break;case $l:i.depthFunc(i.LESS);break;case Sr:i.depthFunc(i.LEQUAL);break;case Xl:i.depthFunc(i.EQUAL);break;case ql:i.depthFunc(i.GEQUAL);break;case Yl:i.depthFunc(i.GREATER);break;case Kl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ae=Ce}},setLocked:function(Ce){O=Ce},setClear:function(Ce){Re!==Ce&&(Se&&(Ce=1-Ce),i.clearDepth(Ce),Re=Ce)},reset:function(){O=!1,se=null,ae=null,Re=null,Se=!1}}}function s(){let O=!1,Se=null,se=null,ae=null,Re=null,Ce=null,Je=null,Ft=null,tn=null;return{setTest:function(vt){O||(vt?le(i.STENCIL_TEST):He(i.STENCIL_TEST))},setMask:function(vt){Se!==vt&&!O&&(i.stencilMask(vt),Se=vt)},setFunc:function(vt,Kt,Lt){(se!==vt||ae!==Kt||Re!==Lt)&&(i.stencilFunc(vt,Kt,Lt),se=vt,ae=Kt,Re=Lt)},setOp:function(vt,Kt,Lt){(Ce!==vt||Je!==Kt||Ft!==Lt)&&(i.stencilOp(vt,Kt,Lt),Ce=vt,Je=Kt,Ft=Lt)},setLocked:function(vt){O=vt},setClear:function(vt){tn!==vt&&(i.clearStencil(vt),tn=vt)},reset:function(){O=!1,Se=null,se=null,ae=null,Re=null,Ce=null,Je=null,Ft=null,tn=null}}}const r=new t,o=new n,a=new s,l=new WeakMap,c=new WeakMap;let h={},u={},f=new WeakMap,g=[],_=null,v=!1,p=null,d=null,w=null,T=null,y=null,z=null,L=null,D=new at(0,0,0),N=0,b=!1,S=null,R=null,V=null,I=null,j=null;const $=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let Q=!1,J=0;const ne=i.getParameter(i.VERSION);ne.indexOf("WebGL")!==-1?(J=parseFloat(/^WebGL (\d)/.exec(ne)[1]),Q=J>=1):ne.indexOf("OpenGL ES")!==-1&&(J=parseFloat(/^OpenGL ES (\d)/.exec(ne)[1]),Q=J>=2);let de=null,he={};const _e=i.getParameter(i.SCISSOR_BOX),ye=i.getParameter(i.VIEWPORT),ge=new Gt().fromArray(_e),re=new Gt().fromArray(ye);function ce(O,Se,se,ae){const Re=new Uint8Array(4),Ce=i.createTexture();i.bindTexture(O,Ce),i.texParameteri(O,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(O,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Je=0;Je<se;Je++)O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY?i.texImage3D(Se,0,i.RGBA,1,1,ae,0,i.RGBA,i.UNSIGNED_BYTE,Re):i.texImage2D(Se+Je,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Re);return Ce}const ve={};ve[i.TEXTURE_2D]=ce(i.TEXTURE_2D,i.TEXTURE_2D,1),ve[i.TEXTURE_CUBE_MAP]=ce(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ve[i.TEXTURE_2D_ARRAY]=ce(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ve[i.TEXTURE_3D]=ce(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),le(i.DEPTH_TEST),o.setFunc(Sr),Qe(!1),tt(gh),le(i.CULL_FACE),k(es);function le(O){h[O]!==!0&&(i.enable(O),h[O]=!0)}function He(O){h[O]!==!1&&(i.disable(O),h[O]=!1)}function Ge(O,Se){return u[O]!==Se?(i.bindFramebuffer(O,Se),u[O]=Se,O===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=Se),O===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=Se),!0):!1}function Fe(O,Se){let se=g,ae=!1;if(O){se=f.get(Se),se===void 0&&(se=[],f.set(Se,se));const Re=O.textures;if(se.length!==Re.length||se[0]!==i.COLOR_ATTACHMENT0){for(let Ce=0,Je=Re.length;Ce<Je;Ce++)se[Ce]=i.COLOR_ATTACHMENT0+Ce;se.length=Re.length,ae=!0}}else se[0]!==i.BACK&&(se[0]=i.BACK,ae=!0);ae&&i.drawBuffers(se)}function lt(O){return _!==O?(i.useProgram(O),_=O,!0):!1}const Ze={[Es]:i.FUNC_ADD,[vy]:i.FUNC_SUBTRACT,[xy]:i.FUNC_REVERSE_SUBTRACT};Ze[My]=i.MIN,Ze[Sy]=i.MAX;const ct={[yy]:i.ZERO,[Ey]:i.ONE,[by]:i.SRC_COLOR,[Hl]:i.SRC_ALPHA,[Py]:i.SRC_ALPHA_SATURATE,[Ry]:i.DST_COLOR,[Ty]:i.DST_ALPHA,[wy]:i.ONE_MINUS_SRC_COLOR,[Vl]:i.ONE_MINUS_SRC_ALPHA,[Cy]:i.ONE_MINUS_DST_COLOR,[Ay]:i.ONE_MINUS_DST_ALPHA,[Ly]:i.CONSTANT_COLOR,[Dy]:i.ONE_MINUS_CONSTANT_COLOR,[Ny]:i.CONSTANT_ALPHA,[Uy]:i.ONE_MINUS_CONSTANT_ALPHA};function k(O,Se,se,ae,Re,Ce,Je,Ft,tn,vt){if(O===es){v===!0&&(He(i.BLEND),v=!1);return}if(v===!1&&(le(i.BLEND),v=!0),O!==_y){if(O!==p||vt!==b){if((d!==Es||y!==Es)&&(i.blendEquation(i.FUNC_ADD),d=Es,y=Es),vt)switch(O){case fr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case _h:i.blendFunc(i.ONE,i.ONE);break;case vh:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case xh:i.blendFuncSeparate(i.ZERO,i.SRC_COLOR,i.ZERO,i.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",O);break}else switch(O){case fr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case _h:i.blendFunc(i.SRC_ALPHA,i.ONE);break;case vh:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case xh:i.blendFunc(i.ZERO,i.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",O);break}w=null,T=null,z=null,L=null,D.set(0,0,0),N=0,p=O,b=vt}return}Re=Re||Se,Ce=Ce||se,Je=Je||ae,(Se!==d||Re!==y)&&(i.blendEquationSeparate(Ze[Se],Ze[Re]),d=Se,y=Re),(se!==w||ae!==T||Ce!==z||Je!==L)&&(i.blendFuncSeparate(ct[se],ct[ae],ct[Ce],ct[Je]),w=se,T=ae,z=Ce,L=Je),(Ft.equals(D)===!1||tn!==N)&&(i.blendColor(Ft.r,Ft.g,Ft.b,tn),D.copy(Ft),N=tn),p=O,b=!1}function Yt(O,Se){O.side===Li?He(i.CULL_FACE):le(i.CULL_FACE);let se=O.side===An;Se&&(se=!se),Qe(se),O.blending===fr&&O.transparent===!1?k(es):k(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);const ae=O.stencilWrite;a.setTest(ae),ae&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),ht(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?le(i.SAMPLE_ALPHA_TO_COVERAGE):He(i.SAMPLE_ALPHA_TO_COVERAGE)}function Qe(O){S!==O&&(O?i.frontFace(i.CW):i.frontFace(i.CCW),S=O)}function tt(O){O!==my?(le(i.CULL_FACE),O!==R&&(O===gh?i.cullFace(i.BACK):O===gy?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):He(i.CULL_FACE),R=O}function We(O){O!==V&&(Q&&i.lineWidth(O),V=O)}function ht(O,Se,se){O?(le(i.POLYGON_OFFSET_FILL),(I!==Se||j!==se)&&(i.polygonOffset(Se,se),I=Se,j=se)):He(i.POLYGON_OFFSET_FILL)}function De(O){O?le(i.SCISSOR_TEST):He(i.SCISSOR_TEST)}function C(O){O===void 0&&(O=i.TEXTURE0+$-1),de!==O&&(i.activeTexture(O),de=O)}function M(O,Se,se){se===void 0&&(de===null?se=i.TEXTURE0+$-1:se=de);let ae=he[se];ae===void 0&&(ae={type:void 0,texture:void 0},he[se]=ae),(ae.type!==O||ae.texture!==Se)&&(de!==se&&(i.activeTexture(se),de=se),i.bindTexture(O,Se||ve[O]),ae.type=O,ae.texture=Se)}function Z(){const O=he[de];O!==void 0&&O.type!==void 0&&(i.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function ee(){try{i.compressedTexImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function G(){try{i.compressedTexImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function ie(){try{i.texSubImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Ee(){try{i.texSubImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function xe(){try{i.compressedTexSubImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Ae(){try{i.compressedTexSubImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function je(){try{i.texStorage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function pe(){try{i.texStorage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Me(){try{i.texImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Oe(){try{i.texImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Be(O){ge.equals(O)===!1&&(i.scissor(O.x,O.y,O.z,O.w),ge.copy(O))}function we(O){re.equals(O)===!1&&(i.viewport(O.x,O.y,O.z,O.w),re.copy(O))}function it(O,Se){let se=c.get(Se);se===void 0&&(se=new WeakMap,c.set(Se,se));let ae=se.get(O);ae===void 0&&(ae=i.getUniformBlockIndex(Se,O.name),se.set(O,ae))}function Ye(O,Se){const ae=c.get(Se).get(O);l.get(Se)!==ae&&(i.uniformBlockBinding(Se,ae,O.__bindingPointIndex),l.set(Se,ae))}function ft(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),h={},de=null,he={},u={},f=new WeakMap,g=[],_=null,v=!1,p=null,d=null,w=null,T=null,y=null,z=null,L=null,D=new at(0,0,0),N=0,b=!1,S=null,R=null,V=null,I=null,j=null,ge.set(0,0,i.canvas.width,i.canvas.height),re.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:le,disable:He,bindFramebuffer:Ge,drawBuffers:Fe,useProgram:lt,setBlending:k,setMaterial:Yt,setFlipSided:Qe,setCullFace:tt,setLineWidth:We,setPolygonOffset:ht,setScissorTest:De,activeTexture:C,bindTexture:M,unbindTexture:Z,compressedTexImage2D:ee,compressedTexImage3D:G,texImage2D:Me,texImage3D:Oe,updateUBOMapping:it,uniformBlockBinding:Ye,texStorage2D:je,texStorage3D:pe,texSubImage2D:ie,texSubImage3D:Ee,compressedTexSubImage2D:xe,compressedTexSubImage3D:Ae,scissor:Be,viewport:we,reset:ft}}function pf(i,e,t,n){const s=nA(n);switch(t){case Rd:return i*e;case Pd:return i*e;case Ld:return i*e*2;case Dd:return i*e/s.components*s.byteLength;case Kc:return i*e/s.components*s.byteLength;case Nd:return i*e*2/s.components*s.byteLength;case jc:return i*e*2/s.components*s.byteLength;case Cd:return i*e*3/s.components*s.byteLength;case si:return i*e*4/s.components*s.byteLength;case Zc:return i*e*4/s.components*s.byteLength;case Zo:case Jo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Qo:case ea:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ec:case nc:return Math.max(i,16)*Math.max(e,8)/4;case Ql:case tc:return Math.max(i,8)*Math.max(e,8)/2;case ic:case sc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case rc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case oc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ac:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case lc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case cc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case uc:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case hc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case fc:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case dc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case pc:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case mc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case gc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case _c:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case vc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case xc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case ta:case Mc:case Sc:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Ud:case yc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Ec:case bc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function nA(i){switch(i){case Oi:case wd:return{byteLength:1,components:1};case ro:case Td:case lo:return{byteLength:2,components:1};case qc:case Yc:return{byteLength:2,components:4};case Ds:case Xc:case Di:return{byteLength:4,components:1};case Ad:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}function iA(i,e,t,n,s,r,o){const a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new mt,h=new WeakMap;let u;const f=new WeakMap;let g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(C,M){return g?new OffscreenCanvas(C,M):ha("canvas")}function v(C,M,Z){let ee=1;const G=De(C);if((G.width>Z||G.height>Z)&&(ee=Z/Math.max(G.width,G.height)),ee<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){const ie=Math.floor(ee*G.width),Ee=Math.floor(ee*G.height);u===void 0&&(u=_(ie,Ee));const xe=M?_(ie,Ee):u;return xe.width=ie,xe.height=Ee,xe.getContext("2d").drawImage(C,0,0,ie,Ee),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+G.width+"x"+G.height+") to ("+ie+"x"+Ee+")."),xe}else return"data"in C&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+G.width+"x"+G.height+")."),C;return C}function p(C){return C.generateMipmaps}function d(C){i.generateMipmap(C)}function w(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(C,M,Z,ee,G=!1){if(C!==null){if(i[C]!==void 0)return i[C];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let ie=M;if(M===i.RED&&(Z===i.FLOAT&&(ie=i.R32F),Z===i.HALF_FLOAT&&(ie=i.R16F),Z===i.UNSIGNED_BYTE&&(ie=i.R8)),M===i.RED_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ie=i.R8UI),Z===i.UNSIGNED_SHORT&&(ie=i.R16UI),Z===i.UNSIGNED_INT&&(ie=i.R32UI),Z===i.BYTE&&(ie=i.R8I),Z===i.SHORT&&(ie=i.R16I),Z===i.INT&&(ie=i.R32I)),M===i.RG&&(Z===i.FLOAT&&(ie=i.RG32F),Z===i.HALF_FLOAT&&(ie=i.RG16F),Z===i.UNSIGNED_BYTE&&(ie=i.RG8)),M===i.RG_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ie=i.RG8UI),Z===i.UNSIGNED_SHORT&&(ie=i.RG16UI),Z===i.UNSIGNED_INT&&(ie=i.RG32UI),Z===i.BYTE&&(ie=i.RG8I),Z===i.SHORT&&(ie=i.RG16I),Z===i.INT&&(ie=i.RG32I)),M===i.RGB_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ie=i.RGB8UI),Z===i.UNSIGNED_SHORT&&(ie=i.RGB16UI),Z===i.UNSIGNED_INT&&(ie=i.RGB32UI),Z===i.BYTE&&(ie=i.RGB8I),Z===i.SHORT&&(ie=i.RGB16I),Z===i.INT&&(ie=i.RGB32I)),M===i.RGBA_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ie=i.RGBA8UI),Z===i.UNSIGNED_SHORT&&(ie=i.RGBA16UI),Z===i.UNSIGNED_INT&&(ie=i.RGBA32UI),Z===i.BYTE&&(ie=i.RGBA8I),Z===i.SHORT&&(ie=i.RGBA16I),Z===i.INT&&(ie=i.RGBA32I)),M===i.RGB&&Z===i.UNSIGNED_INT_5_9_9_9_REV&&(ie=i.RGB9_E5),M===i.RGBA){const Ee=G?Ta:pt.getTransfer(ee);Z===i.FLOAT&&(ie=i.RGBA32F),Z===i.HALF_FLOAT&&(ie=i.RGBA16F),Z===i.UNSIGNED_BYTE&&(ie=Ee===At?i.SRGB8_ALPHA8:i.RGBA8),Z===i.UNSIGNED_SHORT_4_4_4_4&&(ie=i.RGBA4),Z===i.UNSIGNED_SHORT_5_5_5_1&&(ie=i.RGB5_A1)}return(ie===i.R16F||ie===i.R32F||ie===i.RG16F||ie===i.RG32F||ie===i.RGBA16F||ie===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ie}function y(C,M){let Z;return C?M===null||M===Ds||M===br?Z=i.DEPTH24_STENCIL8:M===Di?Z=i.DEPTH32F_STENCIL8:M===ro&&(Z=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Ds||M===br?Z=i.DEPTH_COMPONENT24:M===Di?Z=i.DEPTH_COMPONENT32F:M===ro&&(Z=i.DEPTH_COMPONENT16),Z}function z(C,M){return p(C)===!0||C.isFramebufferTexture&&C.minFilter!==ri&&C.minFilter!==_i?Math.log2(Math.max(M.width,M.height))+1:C.mipmaps!==void 0&&C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?M.mipmaps.length:1}function L(C){const M=C.target;M.removeEventListener("dispose",L),N(M),M.isVideoTexture&&h.delete(M)}function D(C){const M=C.target;M.removeEventListener("dispose",D),S(M)}function N(C){const M=n.get(C);if(M.__webglInit===void 0)return;const Z=C.source,ee=f.get(Z);if(ee){const G=ee[M.__cacheKey];G.usedTimes--,G.usedTimes===0&&b(C),Object.keys(ee).length===0&&f.delete(Z)}n.remove(C)}function b(C){const M=n.get(C);i.deleteTexture(M.__webglTexture);const Z=C.source,ee=f.get(Z);delete ee[M.__cacheKey],o.memory.textures--}function S(C){const M=n.get(C);if(C.depthTexture&&(C.depthTexture.dispose(),n.remove(C.depthTexture)),C.isWebGLCubeRenderTarget)for(let ee=0;ee<6;ee++){if(Array.isArray(M.__webglFramebuffer[ee]))for(let G=0;G<M.__webglFramebuffer[ee].length;G++)i.deleteFramebuffer(M.__webglFramebuffer[ee][G]);else i.deleteFramebuffer(M.__webglFramebuffer[ee]);M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer[ee])}else{if(Array.isArray(M.__webglFramebuffer))for(let ee=0;ee<M.__webglFramebuffer.length;ee++)i.deleteFramebuffer(M.__webglFramebuffer[ee]);else i.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&i.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let ee=0;ee<M.__webglColorRenderbuffer.length;ee++)M.__webglColorRenderbuffer[ee]&&i.deleteRenderbuffer(M.__webglColorRenderbuffer[ee]);M.__webglDepthRenderbuffer&&i.deleteRenderbuffer(M.__webglDepthRenderbuffer)}const Z=C.textures;for(let ee=0,G=Z.length;ee<G;ee++){const ie=n.get(Z[ee]);ie.__webglTexture&&(i.deleteTexture(ie.__webglTexture),o.memory.textures--),n.remove(Z[ee])}n.remove(C)}let R=0;function V(){R=0}function I(){const C=R;return C>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+C+" texture units while this GPU supports only "+s.maxTextures),R+=1,C}function j(C){const M=[];return M.push(C.wrapS),M.push(C.wrapT),M.push(C.wrapR||0),M.push(C.magFilter),M.push(C.minFilter),M.push(C.anisotropy),M.push(C.internalFormat),M.push(C.format),M.push(C.type),M.push(C.generateMipmaps),M.push(C.premultiplyAlpha),M.push(C.flipY),M.push(C.unpackAlignment),M.push(C.colorSpace),M.join()}function $(C,M){const Z=n.get(C);if(C.isVideoTexture&&We(C),C.isRenderTargetTexture===!1&&C.version>0&&Z.__version!==C.version){const ee=C.image;if(ee===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(ee.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{re(Z,C,M);return}}t.bindTexture(i.TEXTURE_2D,Z.__webglTexture,i.TEXTURE0+M)}function Q(C,M){const Z=n.get(C);if(C.version>0&&Z.__version!==C.version){re(Z,C,M);return}t.bindTexture(i.TEXTURE_2D_ARRAY,Z.__webglTexture,i.TEXTURE0+M)}function J(C,M){const Z=n.get(C);if(C.version>0&&Z.__version!==C.version){re(Z,C,M);return}t.bindTexture(i.TEXTURE_3D,Z.__webglTexture,i.TEXTURE0+M)}function ne(C,M){const Z=n.get(C);if(C.version>0&&Z.__version!==C.version){ce(Z,C,M);return}t.bindTexture(i.TEXTURE_CUBE_MAP,Z.__webglTexture,i.TEXTURE0+M)}const de={[ca]:i.REPEAT,[ws]:i.CLAMP_TO_EDGE,[Jl]:i.MIRRORED_REPEAT},he={[ri]:i.NEAREST,[Wy]:i.NEAREST_MIPMAP_NEAREST,[To]:i.NEAREST_MIPMAP_LINEAR,[_i]:i.LINEAR,[Ka]:i.LINEAR_MIPMAP_NEAREST,[Ts]:i.LINEAR_MIPMAP_LINEAR},_e={[Yy]:i.NEVER,[eE]:i.ALWAYS,[Ky]:i.LESS,[Fd]:i.LEQUAL,[jy]:i.EQUAL,[Qy]:i.GEQUAL,[Zy]:i.GREATER,[Jy]:i.NOTEQUAL};function ye(C,M){if(M.type===Di&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===_i||M.magFilter===Ka||M.magFilter===To||M.magFilter===Ts||M.minFilter===_i||M.minFilter===Ka||M.minFilter===To||M.minFilter===Ts)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,de[M.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,de[M.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,de[M.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,he[M.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,he[M.minFilter]),M.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,_e[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===ri||M.minFilter!==To&&M.minFilter!==Ts||M.type===Di&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||n.get(M).__currentAnisotropy){const Z=e.get("EXT_texture_filter_anisotropic");i.texParameterf(C,Z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),n.get(M).__currentAnisotropy=M.anisotropy}}}function ge(C,M){let Z=!1;C.__webglInit===void 0&&(C.__webglInit=!0,M.addEventListener("dispose",L));const ee=M.source;let G=f.get(ee);G===void 0&&(G={},f.set(ee,G));const ie=j(M);if(ie!==C.__cacheKey){G[ie]===void 0&&(G[ie]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Z=!0),G[ie].usedTimes++;const Ee=G[C.__cacheKey];Ee!==void 0&&(G[C.__cacheKey].usedTimes--,Ee.usedTimes===0&&b(M)),C.__cacheKey=ie,C.__webglTexture=G[ie].texture}return Z}function re(C,M,Z){let ee=i.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ee=i.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ee=i.TEXTURE_3D);const G=ge(C,M),ie=M.source;t.bindTexture(ee,C.__webglTexture,i.TEXTURE0+Z);const Ee=n.get(ie);if(ie.version!==Ee.__version||G===!0){t.activeTexture(i.TEXTURE0+Z);const xe=pt.getPrimaries(pt.workingColorSpace),Ae=M.colorSpace===Ji?null:pt.getPrimaries(M.colorSpace),je=M.colorSpace===Ji||xe===Ae?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,je);let pe=v(M.image,!1,s.maxTextureSize);pe=ht(M,pe);const Me=r.convert(M.format,M.colorSpace),Oe=r.convert(M.type);let Be=T(M.internalFormat,Me,Oe,M.colorSpace,M.isVideoTexture);ye(ee,M);let we;const it=M.mipmaps,Ye=M.isVideoTexture!==!0,ft=Ee.__version===void 0||G===!0,O=ie.dataReady,Se=z(M,pe);if(M.isDepthTexture)Be=y(M.format===wr,M.type),ft&&(Ye?t.texStorage2D(i.TEXTURE_2D,1,Be,pe.width,pe.height):t.texImage2D(i.TEXTURE_2D,0,Be,pe.width,pe.height,0,Me,Oe,null));else if(M.isDataTexture)if(it.length>0){Ye&&ft&&t.texStorage2D(i.TEXTURE_2D,Se,Be,it[0].width,it[0].height);for(let se=0,ae=it.length;se<ae;se++)we=it[se],Ye?O&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,we.width,we.height,Me,Oe,we.data):t.texImage2D(i.TEXTURE_2D,se,Be,we.width,we.height,0,Me,Oe,we.data);M.generateMipmaps=!1}else Ye?(ft&&t.texStorage2D(i.TEXTURE_2D,Se,Be,pe.width,pe.height),O&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,pe.width,pe.height,Me,Oe,pe.data)):t.texImage2D(i.TEXTURE_2D,0,Be,pe.width,pe.height,0,Me,Oe,pe.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){Ye&&ft&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Se,Be,it[0].width,it[0].height,pe.depth);for(let se=0,ae=it.length;se<ae;se++)if(we=it[se],M.format!==si)if(Me!==null)if(Ye){if(O)if(M.layerUpdates.size>0){const Re=pf(we.width,we.height,M.format,M.type);for(const Ce of M.layerUpdates){const Je=we.data.subarray(Ce*Re/we.data.BYTES_PER_ELEMENT,(Ce+1)*Re/we.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,Ce,we.width,we.height,1,Me,Je)}M.clearLayerUpdates()}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,0,we.width,we.height,pe.depth,Me,we.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,se,Be,we.width,we.height,pe.depth,0,we.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Ye?O&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,0,we.width,we.height,pe.depth,Me,Oe,we.data):t.texImage3D(i.TEXTURE_2D_ARRAY,se,Be,we.width,we.height,pe.depth,0,Me,Oe,we.data)}else{Ye&&ft&&t.texStorage2D(i.TEXTURE_2D,Se,Be,it[0].width,it[0].height);for(let se=0,ae=it.length;se<ae;se++)we=it[se],M.format!==si?Me!==null?Ye?O&&t.compressedTexSubImage2D(i.TEXTURE_2D,se,0,0,we.width,we.height,Me,we.data):t.compressedTexImage2D(i.TEXTURE_2D,se,Be,we.width,we.height,0,we.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Ye?O&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,we.width,we.height,Me,Oe,we.data):t.texImage2D(i.TEXTURE_2D,se,Be,we.width,we.height,0,Me,Oe,we.data)}else if(M.isDataArrayTexture)if(Ye){if(ft&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Se,Be,pe.width,pe.height,pe.depth),O)if(M.layerUpdates.size>0){const se=pf(pe.width,pe.height,M.format,M.type);for(const ae of M.layerUpdates){const Re=pe.data.subarray(ae*se/pe.data.BYTES_PER_ELEMENT,(ae+1)*se/pe.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ae,pe.width,pe.height,1,Me,Oe,Re)}M.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,pe.width,pe.height,pe.depth,Me,Oe,pe.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,Be,pe.width,pe.height,pe.depth,0,Me,Oe,pe.data);else if(M.isData3DTexture)Ye?(ft&&t.texStorage3D(i.TEXTURE_3D,Se,Be,pe.width,pe.height,pe.depth),O&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,pe.width,pe.height,pe.depth,Me,Oe,pe.data)):t.texImage3D(i.TEXTURE_3D,0,Be,pe.width,pe.height,pe.depth,0,Me,Oe,pe.data);else if(M.isFramebufferTexture){if(ft)if(Ye)t.texStorage2D(i.TEXTURE_2D,Se,Be,pe.width,pe.height);else{let se=pe.width,ae=pe.height;for(let Re=0;Re<Se;Re++)t.texImage2D(i.TEXTURE_2D,Re,Be,se,ae,0,Me,Oe,null),se>>=1,ae>>=1}}else if(it.length>0){if(Ye&&ft){const se=De(it[0]);t.texStorage2D(i.TEXTURE_2D,Se,Be,se.width,se.height)}for(let se=0,ae=it.length;se<ae;se++)we=it[se],Ye?O&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,Me,Oe,we):t.texImage2D(i.TEXTURE_2D,se,Be,Me,Oe,we);M.generateMipmaps=!1}else if(Ye){if(ft){const se=De(pe);t.texStorage2D(i.TEXTURE_2D,Se,Be,se.width,se.height)}O&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,Me,Oe,pe)}else t.texImage2D(i.TEXTURE_2D,0,Be,Me,Oe,pe);p(M)&&d(ee),Ee.__version=ie.version,M.onUpdate&&M.onUpdate(M)}C.__version=M.version}function ce(C,M,Z){if(M.image.length!==6)return;const ee=ge(C,M),G=M.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+Z);const ie=n.get(G);if(G.version!==ie.__version||ee===!0){t.activeTexture(i.TEXTURE0+Z);const Ee=pt.getPrimaries(pt.workingColorSpace),xe=M.colorSpace===Ji?null:pt.getPrimaries(M.colorSpace),Ae=M.colorSpace===Ji||Ee===xe?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ae);const je=M.isCompressedTexture||M.image[0].isCompressedTexture,pe=M.image[0]&&M.image[0].isDataTexture,Me=[];for(let ae=0;ae<6;ae++)!je&&!pe?Me[ae]=v(M.image[ae],!0,s.maxCubemapSize):Me[ae]=pe?M.image[ae].image:M.image[ae],Me[ae]=ht(M,Me[ae]);const Oe=Me[0],Be=r.convert(M.format,M.colorSpace),we=r.convert(M.type),it=T(M.internalFormat,Be,we,M.colorSpace),Ye=M.isVideoTexture!==!0,ft=ie.__version===void 0||ee===!0,O=G.dataReady;let Se=z(M,Oe);ye(i.TEXTURE_CUBE_MAP,M);let se;if(je){Ye&&ft&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Se,it,Oe.width,Oe.height);for(let ae=0;ae<6;ae++){se=Me[ae].mipmaps;for(let Re=0;Re<se.length;Re++){const Ce=se[Re];M.format!==si?Be!==null?Ye?O&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re,0,0,Ce.width,Ce.height,Be,Ce.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re,it,Ce.width,Ce.height,0,Ce.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ye?O&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re,0,0,Ce.width,Ce.height,Be,we,Ce.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re,it,Ce.width,Ce.height,0,Be,we,Ce.data)}}}else{if(se=M.mipmaps,Ye&&ft){se.length>0&&Se++;const ae=De(Me[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Se,it,ae.width,ae.height)}for(let ae=0;ae<6;ae++)if(pe){Ye?O&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0,0,0,Me[ae].width,Me[ae].height,Be,we,Me[ae].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0,it,Me[ae].width,Me[ae].height,0,Be,we,Me[ae].data);for(let Re=0;Re<se.length;Re++){const Je=se[Re].image[ae].image;Ye?O&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re+1,0,0,Je.width,Je.height,Be,we,Je.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re+1,it,Je.width,Je.height,0,Be,we,Je.data)}}else{Ye?O&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0,0,0,Be,we,Me[ae]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0,it,Be,we,Me[ae]);for(let Re=0;Re<se.length;Re++){const Ce=se[Re];Ye?O&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re+1,0,0,Be,we,Ce.image[ae]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,Re+1,it,Be,we,Ce.image[ae])}}}p(M)&&d(i.TEXTURE_CUBE_MAP),ie.__version=G.version,M.onUpdate&&M.onUpdate(M)}C.__version=M.version}function ve(C,M,Z,ee,G,ie){const Ee=r.convert(Z.format,Z.colorSpace),xe=r.convert(Z.type),Ae=T(Z.internalFormat,Ee,xe,Z.colorSpace),je=n.get(M),pe=n.get(Z);if(pe.__renderTarget=M,!je.__hasExternalTextures){const Me=Math.max(1,M.width>>ie),Oe=Math.max(1,M.height>>ie);G===i.TEXTURE_3D||G===i.TEXTURE_2D_ARRAY?t.texImage3D(G,ie,Ae,Me,Oe,M.depth,0,Ee,xe,null):t.texImage2D(G,ie,Ae,Me,Oe,0,Ee,xe,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),tt(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ee,G,pe.__webglTexture,0,Qe(M)):(G===i.TEXTURE_2D||G>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&G<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ee,G,pe.__webglTexture,ie),t.bindFramebuffer(i.FRAMEBUFFER,null)}function le(C,M,Z){if(i.bindRenderbuffer(i.RENDERBUFFER,C),M.depthBuffer){const ee=M.depthTexture,G=ee&&ee.isDepthTexture?ee.type:null,ie=y(M.stencilBuffer,G),Ee=M.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=Qe(M);tt(M)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,xe,ie,M.width,M.height):Z?i.renderbufferStorageMultisample(i.RENDERBUFFER,xe,ie,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,ie,M.width,M.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Ee,i.RENDERBUFFER,C)}else{const ee=M.textures;for(let G=0;G<ee.length;G++){const ie=ee[G],Ee=r.convert(ie.format,ie.colorSpace),xe=r.convert(ie.type),Ae=T(ie.internalFormat,Ee,xe,ie.colorSpace),je=Qe(M);Z&&tt(M)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,je,Ae,M.width,M.height):tt(M)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,je,Ae,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,Ae,M.width,M.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function He(C,M){if(M&&M.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const ee=n.get(M.depthTexture);ee.__renderTarget=M,(!ee.__webglTexture||M.depthTexture.image.width!==M.width||M.depthTexture.image.height!==M.height)&&(M.depthTexture.image.width=M.width,M.depthTexture.image.height=M.height,M.depthTexture.needsUpdate=!0),$(M.depthTexture,0);const G=ee.__webglTexture,ie=Qe(M);if(M.depthTexture.format===dr)tt(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,G,0,ie):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,G,0);else if(M.depthTexture.format===wr)tt(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,G,0,ie):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,G,0);else throw new Error("Unknown depthTexture format")}function Ge(C){const M=n.get(C),Z=C.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==C.depthTexture){const ee=C.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ee){const G=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ee.removeEventListener("dispose",G)};ee.addEventListener("dispose",G),M.__depthDisposeCallback=G}M.__boundDepthTexture=ee}if(C.depthTexture&&!M.__autoAllocateDepthBuffer){if(Z)throw new Error("target.depthTexture not supported in Cube render targets");He(M.__webglFramebuffer,C)}else if(Z){M.__webglDepthbuffer=[];for(let ee=0;ee<6;ee++)if(t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[ee]),M.__webglDepthbuffer[ee]===void 0)M.__webglDepthbuffer[ee]=i.createRenderbuffer(),le(M.__webglDepthbuffer[ee],C,!1);else{const G=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ie=M.__webglDepthbuffer[ee];i.bindRenderbuffer(i.RENDERBUFFER,ie),i.framebufferRenderbuffer(i.FRAMEBUFFER,G,i.RENDERBUFFER,ie)}}else if(t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=i.createRenderbuffer(),le(M.__webglDepthbuffer,C,!1);else{const ee=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,G=M.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,G),i.framebufferRenderbuffer(i.FRAMEBUFFER,ee,i.RENDERBUFFER,G)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Fe(C,M,Z){const ee=n.get(C);M!==void 0&&ve(ee.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Z!==void 0&&Ge(C)}function lt(C){const M=C.texture,Z=n.get(C),ee=n.get(M);C.addEventListener("dispose",D);const G=C.textures,ie=C.isWebGLCubeRenderTarget===!0,Ee=G.length>1;if(Ee||(ee.__webglTexture===void 0&&(ee.__webglTexture=i.createTexture()),ee.__version=M.version,o.memory.textures++),ie){Z.__webglFramebuffer=[];for(let xe=0;xe<6;xe++)if(M.mipmaps&&M.mipmaps.length>0){Z.__webglFramebuffer[xe]=[];for(let Ae=0;Ae<M.mipmaps.length;Ae++)Z.__webglFramebuffer[xe][Ae]=i.createFramebuffer()}else Z.__webglFramebuffer[xe]=i.createFramebuffer()}else{if(M.mipmaps&&M.mipmaps.length>0){Z.__webglFramebuffer=[];for(let xe=0;xe<M.mipmaps.length;xe++)Z.__webglFramebuffer[xe]=i.createFramebuffer()}else Z.__webglFramebuffer=i.createFramebuffer();if(Ee)for(let xe=0,Ae=G.length;xe<Ae;xe++){const je=n.get(G[xe]);je.__webglTexture===void 0&&(je.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&tt(C)===!1){Z.__webglMultisampledFramebuffer=i.createFramebuffer(),Z.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,Z.__webglMultisampledFramebuffer);for(let xe=0;xe<G.length;xe++){const Ae=G[xe];Z.__webglColorRenderbuffer[xe]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Z.__webglColorRenderbuffer[xe]);const je=r.convert(Ae.format,Ae.colorSpace),pe=r.convert(Ae.type),Me=T(Ae.internalFormat,je,pe,Ae.colorSpace,C.isXRRenderTarget===!0),Oe=Qe(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,Oe,Me,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+xe,i.RENDERBUFFER,Z.__webglColorRenderbuffer[xe])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(Z.__webglDepthRenderbuffer=i.createRenderbuffer(),le(Z.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ie){t.bindTexture(i.TEXTURE_CUBE_MAP,ee.__webglTexture),ye(i.TEXTURE_CUBE_MAP,M);for(let xe=0;xe<6;xe++)if(M.mipmaps&&M.mipmaps.length>0)for(let Ae=0;Ae<M.mipmaps.length;Ae++)ve(Z.__webglFramebuffer[xe][Ae],C,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,Ae);else ve(Z.__webglFramebuffer[xe],C,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,0);p(M)&&d(i.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Ee){for(let xe=0,Ae=G.length;xe<Ae;xe++){const je=G[xe],pe=n.get(je);t.bindTexture(i.TEXTURE_2D,pe.__webglTexture),ye(i.TEXTURE_2D,je),ve(Z.__webglFramebuffer,C,je,i.COLOR_ATTACHMENT0+xe,i.TEXTURE_2D,0),p(je)&&d(i.TEXTURE_2D)}t.unbindTexture()}else{let xe=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(xe=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(xe,ee.__webglTexture),ye(xe,M),M.mipmaps&&M.mipmaps.length>0)for(let Ae=0;Ae<M.mipmaps.length;Ae++)ve(Z.__webglFramebuffer[Ae],C,M,i.COLOR_ATTACHMENT0,xe,Ae);else ve(Z.__webglFramebuffer,C,M,i.COLOR_ATTACHMENT0,xe,0);p(M)&&d(xe),t.unbindTexture()}C.depthBuffer&&Ge(C)}function Ze(C){const M=C.textures;for(let Z=0,ee=M.length;Z<ee;Z++){const G=M[Z];if(p(G)){const ie=w(C),Ee=n.get(G).__webglTexture;t.bindTexture(ie,Ee),d(ie),t.unbindTexture()}}}const ct=[],k=[];function Yt(C){if(C.samples>0){if(tt(C)===!1){const M=C.textures,Z=C.width,ee=C.height;let G=i.COLOR_BUFFER_BIT;const ie=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Ee=n.get(C),xe=M.length>1;if(xe)for(let Ae=0;Ae<M.length;Ae++)t.bindFramebuffer(i.FRAMEBUFFER,Ee.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Ee.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Ee.__webglMultisampledFramebuffer),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ee.__webglFramebuffer);for(let Ae=0;Ae<M.length;Ae++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(G|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(G|=i.STENCIL_BUFFER_BIT)),xe){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Ee.__webglColorRenderbuffer[Ae]);const je=n.get(M[Ae]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,je,0)}i.blitFramebuffer(0,0,Z,ee,0,0,Z,ee,G,i.NEAREST),l===!0&&(ct.length=0,k.length=0,ct.push(i.COLOR_ATTACHMENT0+Ae),C.depthBuffer&&C.resolveDepthBuffer===!1&&(ct.push(ie),k.push(ie),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,k)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,ct))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),xe)for(let Ae=0;Ae<M.length;Ae++){t.bindFramebuffer(i.FRAMEBUFFER,Ee.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.RENDERBUFFER,Ee.__webglColorRenderbuffer[Ae]);const je=n.get(M[Ae]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Ee.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.TEXTURE_2D,je,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ee.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.resolveDepthBuffer===!1&&l){const M=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[M])}}}function Qe(C){return Math.min(s.maxSamples,C.samples)}function tt(C){const M=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function We(C){const M=o.render.frame;h.get(C)!==M&&(h.set(C,M),C.update())}function ht(C,M){const Z=C.colorSpace,ee=C.format,G=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||Z!==Pr&&Z!==Ji&&(pt.getTransfer(Z)===At?(ee!==si||G!==Oi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",Z)),M}function De(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=I,this.resetTextureUnits=V,this.setTexture2D=$,this.setTexture2DArray=Q,this.setTexture3D=J,this.setTextureCube=ne,this.rebindTextures=Fe,this.setupRenderTarget=lt,this.updateRenderTargetMipmap=Ze,this.updateMultisampleRenderTarget=Yt,this.setupDepthRenderbuffer=Ge,this.setupFrameBufferTexture=ve,this.useMultisampledRTT=tt}function sA(i,e){function t(n,s=Ji){let r;const o=pt.getTransfer(s);if(n===Oi)return i.UNSIGNED_BYTE;if(n===qc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Yc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Ad)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===wd)return i.BYTE;if(n===Td)return i.SHORT;if(n===ro)return i.UNSIGNED_SHORT;if(n===Xc)return i.INT;if(n===Ds)return i.UNSIGNED_INT;if(n===Di)return i.FLOAT;if(n===lo)return i.HALF_FLOAT;if(n===Rd)return i.ALPHA;if(n===Cd)return i.RGB;if(n===si)return i.RGBA;if(n===Pd)return i.LUMINANCE;if(n===Ld)return i.LUMINANCE_ALPHA;if(n===dr)return i.DEPTH_COMPONENT;if(n===wr)return i.DEPTH_STENCIL;if(n===Dd)return i.RED;if(n===Kc)return i.RED_INTEGER;if(n===Nd)return i.RG;if(n===jc)return i.RG_INTEGER;if(n===Zc)return i.RGBA_INTEGER;if(n===Zo||n===Jo||n===Qo||n===ea)if(o===At)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Zo)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Jo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Qo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===ea)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Zo)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Jo)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Qo)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===ea)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Ql||n===ec||n===tc||n===nc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Ql)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===ec)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===tc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===nc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===ic||n===sc||n===rc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===ic||n===sc)return o===At?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===rc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===oc||n===ac||n===lc||n===cc||n===uc||n===hc||n===fc||n===dc||n===pc||n===mc||n===gc||n===_c||n===vc||n===xc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===oc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ac)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===lc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===cc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===uc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===hc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===fc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===dc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===pc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===mc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===gc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===_c)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===vc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===xc)return o===At?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===ta||n===Mc||n===Sc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===ta)return o===At?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Mc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Sc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Ud||n===yc||n===Ec||n===bc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===ta)return r.COMPRESSED_RED_RGTC1_EXT;if(n===yc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ec)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===bc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===br?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}class rA extends $n{constructor(e=[]){super(),this.isArrayCamera=!0,this.cameras=e}}class Qi extends Jt{constructor(){super(),this.isGroup=!0,this.type="Group"}}const oA={type:"move"};class bl{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Qi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Qi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Y,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Y),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Qi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Y,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Y),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){const t=this._hand;if(t)for(const n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(const v of e.hand.values()){const p=t.getJointPose(v,n),d=this._getHandJoint(c,v);p!==null&&(d.matrix.fromArray(p.transform.matrix),d.matrix.decompose(d.position,d.rotation,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=p.radius),d.visible=p!==null}const h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),g=.02,_=.005;c.inputState.pinching&&f>g+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=g-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(oA)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){const n=new Qi;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}}const aA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,lA=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`;class cA{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t,n){if(this.texture===null){const s=new yn,r=e.properties.get(s);r.__webglTexture=t.texture,(t.depthNear!=n.depthNear||t.depthFar!=n.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=s}}getMesh(e){if(this.texture!==null&&this.mesh===null){const t=e.cameras[0].viewport,n=new ss({vertexShader:aA,fragmentShader:lA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new pn(new fo(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class uA extends Lr{constructor(e,t){super();const n=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,g=null,_=null;const v=new cA,p=t.getContextAttributes();let d=null,w=null;const T=[],y=[],z=new mt;let L=null;const D=new $n;D.viewport=new Gt;const N=new $n;N.viewport=new Gt;const b=[D,N],S=new rA;let R=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(re){let ce=T[re];return ce===void 0&&(ce=new bl,T[re]=ce),ce.getTargetRaySpace()},this.getControllerGrip=function(re){let ce=T[re];return ce===void 0&&(ce=new bl,T[re]=ce),ce.getGripSpace()},this.getHand=function(re){let ce=T[re];return ce===void 0&&(ce=new bl,T[re]=ce),ce.getHandSpace()};function I(re){const ce=y.indexOf(re.inputSource);if(ce===-1)return;const ve=T[ce];ve!==void 0&&(ve.update(re.inputSource,re.frame,c||o),ve.dispatchEvent({type:re.type,data:re.inputSource}))}function j(){s.removeEventListener("select",I),s.removeEventListener("selectstart",I),s.removeEventListener("selectend",I),s.removeEventListener("squeeze",I),s.removeEventListener("squeezestart",I),s.removeEventListener("squeezeend",I),s.removeEventListener("end",j),s.removeEventListener("inputsourceschange",$);for(let re=0;re<T.length;re++){const ce=y[re];ce!==null&&(y[re]=null,T[re].disconnect(ce))}R=null,V=null,v.reset(),e.setRenderTarget(d),g=null,f=null,u=null,s=null,w=null,ge.stop(),n.isPresenting=!1,e.setPixelRatio(L),e.setSize(z.width,z.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(re){r=re,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(re){a=re,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(re){c=re},this.getBaseLayer=function(){return f!==null?f:g},this.getBinding=function(){return u},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(re){if(s=re,s!==null){if(d=e.getRenderTarget(),s.addEventListener("select",I),s.addEventListener("selectstart",I),s.addEventListener("selectend",I),s.addEventListener("squeeze",I),s.addEventListener("squeezestart",I),s.addEventListener("squeezeend",I),s.addEventListener("end",j),s.addEventListener("inputsourceschange",$),p.xrCompatible!==!0&&await t.makeXRCompatible(),L=e.getPixelRatio(),e.getSize(z),s.renderState.layers===void 0){const ce={antialias:p.antialias,alpha:!0,depth:p.depth,stencil:p.stencil,framebufferScaleFactor:r};g=new XRWebGLLayer(s,t,ce),s.updateRenderState({baseLayer:g}),e.setPixelRatio(1),e.setSize(g.framebufferWidth,g.framebufferHeight,!1),w=new Ns(g.framebufferWidth,g.framebufferHeight,{format:si,type:Oi,colorSpace:e.outputColorSpace,stencilBuffer:p.stencil})}else{let ce=null,ve=null,le=null;p.depth&&(le=p.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ce=p.stencil?wr:dr,ve=p.stencil?br:Ds);const He={colorFormat:t.RGBA8,depthFormat:le,scaleFactor:r};u=new XRWebGLBinding(s,t),f=u.createProjectionLayer(He),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),w=new Ns(f.textureWidth,f.textureHeight,{format:si,type:Oi,depthTexture:new Yd(f.textureWidth,f.textureHeight,ve,void 0,void 0,void 0,void 0,void 0,void 0,ce),stencilBuffer:p.stencil,colorSpace:e.outputColorSpace,samples:p.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1})}w.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ge.setContext(s),ge.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return v.getDepthTexture()};function $(re){for(let ce=0;ce<re.removed.length;ce++){const ve=re.removed[ce],le=y.indexOf(ve);le>=0&&(y[le]=null,T[le].disconnect(ve))}for(let ce=0;ce<re.added.length;ce++){const ve=re.added[ce];let le=y.indexOf(ve);if(le===-1){for(let Ge=0;Ge<T.length;Ge++)if(Ge>=y.length){y.push(ve),le=Ge;break}else if(y[Ge]===null){y[Ge]=ve,le=Ge;break}if(le===-1)break}const He=T[le];He&&He.connect(ve)}}const Q=new Y,J=new Y;function ne(re,ce,ve){Q.setFromMatrixPosition(ce.matrixWorld),J.setFromMatrixPosition(ve.matrixWorld);const le=Q.distanceTo(J),He=ce.projectionMatrix.elements,Ge=ve.projectionMatrix.elements,Fe=He[14]/(He[10]-1),lt=He[14]/(He[10]+1),Ze=(He[9]+1)/He[5],ct=(He[9]-1)/He[5],k=(He[8]-1)/He[0],Yt=(Ge[8]+1)/Ge[0],Qe=Fe*k,tt=Fe*Yt,We=le/(-k+Yt),ht=We*-k;if(ce.matrixWorld.decompose(re.position,re.quaternion,re.scale),re.translateX(ht),re.translateZ(We),re.matrixWorld.compose(re.position,re.quaternion,re.scale),re.matrixWorldInverse.copy(re.matrixWorld).invert(),He[10]===-1)re.projectionMatrix.copy(ce.projectionMatrix),re.projectionMatrixInverse.copy(ce.projectionMatrixInverse);else{const De=Fe+We,C=lt+We,M=Qe-ht,Z=tt+(le-ht),ee=Ze*lt/C*De,G=ct*lt/C*De;re.projectionMatrix.makePerspective(M,Z,ee,G,De,C),re.projectionMatrixInverse.copy(re.projectionMatrix).invert()}}function de(re,ce){ce===null?re.matrixWorld.copy(re.matrix):re.matrixWorld.multiplyMatrices(ce.matrixWorld,re.matrix),re.matrixWorldInverse.copy(re.matrixWorld).invert()}this.updateCamera=function(re){if(s===null)return;let ce=re.near,ve=re.far;v.texture!==null&&(v.depthNear>0&&(ce=v.depthNear),v.depthFar>0&&(ve=v.depthFar)),S.near=N.near=D.near=ce,S.far=N.far=D.far=ve,(R!==S.near||V!==S.far)&&(s.updateRenderState({depthNear:S.near,depthFar:S.far}),R=S.near,V=S.far),D.layers.mask=re.layers.mask|2,N.layers.mask=re.layers.mask|4,S.layers.mask=D.layers.mask|N.layers.mask;const le=re.parent,He=S.cameras;de(S,le);for(let Ge=0;Ge<He.length;Ge++)de(He[Ge],le);He.length===2?ne(S,D,N):S.projectionMatrix.copy(D.projectionMatrix),he(re,S,le)};function he(re,ce,ve){ve===null?re.matrix.copy(ce.matrixWorld):(re.matrix.copy(ve.matrixWorld),re.matrix.invert(),re.matrix.multiply(ce.matrixWorld)),re.matrix.decompose(re.position,re.quaternion,re.scale),re.updateMatrixWorld(!0),re.projectionMatrix.copy(ce.projectionMatrix),re.projectionMatrixInverse.copy(ce.projectionMatrixInverse),re.isPerspectiveCamera&&(re.fov=wc*2*Math.atan(1/re.projectionMatrix.elements[5]),re.zoom=1)}this.getCamera=function(){return S},this.getFoveation=function(){if(!(f===null&&g===null))return l},this.setFoveation=function(re){l=re,f!==null&&(f.fixedFoveation=re),g!==null&&g.fixedFoveation!==void 0&&(g.fixedFoveation=re)},this.hasDepthSensing=function(){return v.texture!==null},this.getDepthSensingMesh=function(){return v.getMesh(S)};let _e=null;function ye(re,ce){if(h=ce.getViewerPose(c||o),_=ce,h!==null){const ve=h.views;g!==null&&(e.setRenderTargetFramebuffer(w,g.framebuffer),e.setRenderTarget(w));let le=!1;ve.length!==S.cameras.length&&(S.cameras.length=0,le=!0);for(let Ge=0;Ge<ve.length;Ge++){const Fe=ve[Ge];let lt=null;if(g!==null)lt=g.getViewport(Fe);else{const ct=u.getViewSubImage(f,Fe);lt=ct.viewport,Ge===0&&(e.setRenderTargetTextures(w,ct.colorTexture,f.ignoreDepthValues?void 0:ct.depthStencilTexture),e.setRenderTarget(w))}let Ze=b[Ge];Ze===void 0&&(Ze=new $n,Ze.layers.enable(Ge),Ze.viewport=new Gt,b[Ge]=Ze),Ze.matrix.fromArray(Fe.transform.matrix),Ze.matrix.decompose(Ze.position,Ze.quaternion,Ze.scale),Ze.projectionMatrix.fromArray(Fe.projectionMatrix),Ze.projectionMatrixInverse.copy(Ze.projectionMatrix).invert(),Ze.viewport.set(lt.x,lt.y,lt.width,lt.height),Ge===0&&(S.matrix.copy(Ze.matrix),S.matrix.decompose(S.position,S.quaternion,S.scale)),le===!0&&S.cameras.push(Ze)}const He=s.enabledFeatures;if(He&&He.includes("depth-sensing")){const Ge=u.getDepthInformation(ve[0]);Ge&&Ge.isValid&&Ge.texture&&v.init(e,Ge,s.renderState)}}for(let ve=0;ve<T.length;ve++){const le=y[ve],He=T[ve];le!==null&&He!==void 0&&He.update(le,ce,c||o)}_e&&_e(re,ce),ce.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ce}),_=null}const ge=new Xd;ge.setAnimationLoop(ye),this.setAnimationLoop=function(re){_e=re},this.dispose=function(){}}}const gs=new xi,hA=new Bt;function fA(i,e){function t(p,d){p.matrixAutoUpdate===!0&&p.updateMatrix(),d.value.copy(p.matrix)}function n(p,d){d.color.getRGB(p.fogColor.value,Gd(i)),d.isFog?(p.fogNear.value=d.near,p.fogFar.value=d.far):d.isFogExp2&&(p.fogDensity.value=d.density)}function s(p,d,w,T,y){d.isMeshBasicMaterial||d.isMeshLambertMaterial?r(p,d):d.isMeshToonMaterial?(r(p,d),u(p,d)):d.isMeshPhongMaterial?(r(p,d),h(p,d)):d.isMeshStandardMaterial?(r(p,d),f(p,d),d.isMeshPhysicalMaterial&&g(p,d,y)):d.isMeshMatcapMaterial?(r(p,d),_(p,d)):d.isMeshDepthMaterial?r(p,d):d.isMeshDistanceMaterial?(r(p,d),v(p,d)):d.isMeshNormalMaterial?r(p,d):d.isLineBasicMaterial?(o(p,d),d.isLineDashedMaterial&&a(p,d)):d.isPointsMaterial?l(p,d,w,T):d.isSpriteMaterial?c(p,d):d.isShadowMaterial?(p.color.value.copy(d.color),p.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(p,d){p.opacity.value=d.opacity,d.color&&p.diffuse.value.copy(d.color),d.emissive&&p.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(p.map.value=d.map,t(d.map,p.mapTransform)),d.alphaMap&&(p.alphaMap.value=d.alphaMap,t(d.alphaMap,p.alphaMapTransform)),d.bumpMap&&(p.bumpMap.value=d.bumpMap,t(d.bumpMap,p.bumpMapTransform),p.bumpScale.value=d.bumpScale,d.side===An&&(p.bumpScale.value*=-1)),d.normalMap&&(p.normalMap.value=d.normalMap,t(d.normalMap,p.normalMapTransform),p.normalScale.value.copy(d.normalScale),d.side===An&&p.normalScale.value.negate()),d.displacementMap&&(p.displacementMap.value=d.displacementMap,t(d.displacementMap,p.displacementMapTransform),p.displacementScale.value=d.displacementScale,p.displacementBias.value=d.displacementBias),d.emissiveMap&&(p.emissiveMap.value=d.emissiveMap,t(d.emissiveMap,p.emissiveMapTransform)),d.specularMap&&(p.specularMap.value=d.specularMap,t(d.specularMap,p.specularMapTransform)),d.alphaTest>0&&(p.alphaTest.value=d.alphaTest);const w=e.get(d),T=w.envMap,y=w.envMapRotation;T&&(p.envMap.value=T,gs.copy(y),gs.x*=-1,gs.y*=-1,gs.z*=-1,T.isCubeTexture&&T.isRenderTargetTexture===!1&&(gs.y*=-1,gs.z*=-1),p.envMapRotation.value.setFromMatrix4(hA.makeRotationFromEuler(gs)),p.flipEnvMap.value=T.isCubeTexture&&T.isRenderTargetTexture===!1?-1:1,p.reflectivity.value=d.reflectivity,p.ior.value=d.ior,p.refractionRatio.value=d.refractionRatio),d.lightMap&&(p.lightMap.value=d.lightMap,p.lightMapIntensity.value=d.lightMapIntensity,t(d.lightMap,p.lightMapTransform)),d.aoMap&&(p.aoMap.value=d.aoMap,p.aoMapIntensity.value=d.aoMapIntensity,t(d.aoMap,p.aoMapTransform))}function o(p,d){p.diffuse.value.copy(d.color),p.opacity.value=d.opacity,d.map&&(p.map.value=d.map,t(d.map,p.mapTransform))}function a(p,d){p.dashSize.value=d.dashSize,p.totalSize.value=d.dashSize+d.gapSize,p.scale.value=d.scale}function l(p,d,w,T){p.diffuse.value.copy(d.color),p.opacity.value=d.opacity,p.size.value=d.size*w,p.scale.value=T*.5,d.map&&(p.map.value=d.map,t(d.map,p.uvTransform)),d.alphaMap&&(p.alphaMap.value=d.alphaMap,t(d.alphaMap,p.alphaMapTransform)),d.alphaTest>0&&(p.alphaTest.value=d.alphaTest)}function c(p,d){p.diffuse.value.copy(d.color),p.opacity.value=d.opacity,p.rotation.value=d.rotation,d.map&&(p.map.value=d.map,t(d.map,p.mapTransform)),d.alphaMap&&(p.alphaMap.value=d.alphaMap,t(d.alphaMap,p.alphaMapTransform)),d.alphaTest>0&&(p.alphaTest.value=d.alphaTest)}function h(p,d){p.specular.value.copy(d.specular),p.shininess.value=Math.max(d.shininess,1e-4)}function u(p,d){d.gradientMap&&(p.gradientMap.value=d.gradientMap)}function f(p,d){p.metalness.value=d.metalness,d.metalnessMap&&(p.metalnessMap.value=d.metalnessMap,t(d.metalnessMap,p.metalnessMapTransform)),p.roughness.value=d.roughness,d.roughnessMap&&(p.roughnessMap.value=d.roughnessMap,t(d.roughnessMap,p.roughnessMapTransform)),d.envMap&&(p.envMapIntensity.value=d.envMapIntensity)}function g(p,d,w){p.ior.value=d.ior,d.sheen>0&&(p.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),p.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(p.sheenColorMap.value=d.sheenColorMap,t(d.sheenColorMap,p.sheenColorMapTransform)),d.sheenRoughnessMap&&(p.sheenRoughnessMap.value=d.sheenRoughnessMap,t(d.sheenRoughnessMap,p.sheenRoughnessMapTransform))),d.clearcoat>0&&(p.clearcoat.value=d.clearcoat,p.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(p.clearcoatMap.value=d.clearcoatMap,t(d.clearcoatMap,p.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,t(d.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(p.clearcoatNormalMap.value=d.clearcoatNormalMap,t(d.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===An&&p.clearcoatNormalScale.value.negate())),d.dispersion>0&&(p.dispersion.value=d.dispersion),d.iridescence>0&&(p.iridescence.value=d.iridescence,p.iridescenceIOR.value=d.iridescenceIOR,p.iridescenceThicknessMinimum.value=d.iridescenceThicknessRange[0],p.iridescenceThicknessMaximum.value=d.iridescenceThicknessRange[1],d.iridescenceMap&&(p.iridescenceMap.value=d.iridescenceMap,t(d.iridescenceMap,p.iridescenceMapTransform)),d.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=d.iridescenceThicknessMap,t(d.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),d.transmission>0&&(p.transmission.value=d.transmission,p.transmissionSamplerMap.value=w.texture,p.transmissionSamplerSize.value.set(w.width,w.height),d.transmissionMap&&(p.transmissionMap.value=d.transmissionMap,t(d.transmissionMap,p.transmissionMapTransform)),p.thickness.value=d.thickness,d.thicknessMap&&(p.thicknessMap.value=d.thicknessMap,t(d.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=d.attenuationDistance,p.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(p.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(p.anisotropyMap.value=d.anisotropyMap,t(d.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=d.specularIntensity,p.specularColor.value.copy(d.specularColor),d.specularColorMap&&(p.specularColorMap.value=d.specularColorMap,t(d.specularColorMap,p.specularColorMapTransform)),d.specularIntensityMap&&(p.specularIntensityMap.value=d.specularIntensityMap,t(d.specularIntensityMap,p.specularIntensityMapTransform))}function _(p,d){d.matcap&&(p.matcap.value=d.matcap)}function v(p,d){const w=e.get(d).light;p.referencePosition.value.setFromMatrixPosition(w.matrixWorld),p.nearDistance.value=w.shadow.camera.near,p.farDistance.value=w.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function dA(i,e,t,n){let s={},r={},o=[];const a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(w,T){const y=T.program;n.uniformBlockBinding(w,y)}function c(w,T){let y=s[w.id];y===void 0&&(_(w),y=h(w),s[w.id]=y,w.addEventListener("dispose",p));const z=T.program;n.updateUBOMapping(w,z);const L=e.render.frame;r[w.id]!==L&&(f(w),r[w.id]=L)}function h(w){const T=u();w.__bindingPointIndex=T;const y=i.createBuffer(),z=w.__size,L=w.usage;return i.bindBuffer(i.UNIFORM_BUFFER,y),i.bufferData(i.UNIFORM_BUFFER,z,L),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,T,y),y}function u(){for(let w=0;w<a;w++)if(o.indexOf(w)===-1)return o.push(w),w;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(w){const T=s[w.id],y=w.uniforms,z=w.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let L=0,D=y.length;L<D;L++){const N=Array.isArray(y[L])?y[L]:[y[L]];for(let b=0,S=N.length;b<S;b++){const R=N[b];if(g(R,L,b,z)===!0){const V=R.__offset,I=Array.isArray(R.value)?R.value:[R.value];let j=0;for(let $=0;$<I.length;$++){const Q=I[$],J=v(Q);typeof Q=="number"||typeof Q=="boolean"?(R.__data[0]=Q,i.bufferSubData(i.UNIFORM_BUFFER,V+j,R.__data)):Q.isMatrix3?(R.__data[0]=Q.elements[0],R.__data[1]=Q.elements[1],R.__data[2]=Q.elements[2],R.__data[3]=0,R.__data[4]=Q.elements[3],R.__data[5]=Q.elements[4],R.__data[6]=Q.elements[5],R.__data[7]=0,R.__data[8]=Q.elements[6],R.__data[9]=Q.elements[7],R.__data[10]=Q.elements[8],R.__data[11]=0):(Q.toArray(R.__data,j),j+=J.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,V,R.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function g(w,T,y,z){const L=w.value,D=T+"_"+y;if(z[D]===void 0)return typeof L=="number"||typeof L=="boolean"?z[D]=L:z[D]=L.clone(),!0;{const N=z[D];if(typeof L=="number"||typeof L=="boolean"){if(N!==L)return z[D]=L,!0}else if(N.equals(L)===!1)return N.copy(L),!0}return!1}function _(w){const T=w.uniforms;let y=0;const z=16;for(let D=0,N=T.length;D<N;D++){const b=Array.isArray(T[D])?T[D]:[T[D]];for(let S=0,R=b.length;S<R;S++){const V=b[S],I=Array.isArray(V.value)?V.value:[V.value];for(let j=0,$=I.length;j<$;j++){const Q=I[j],J=v(Q),ne=y%z,de=ne%J.boundary,he=ne+de;y+=de,he!==0&&z-he<J.storage&&(y+=z-he),V.__data=new Float32Array(J.storage/Float32Array.BYTES_PER_ELEMENT),V.__offset=y,y+=J.storage}}}const L=y%z;return L>0&&(y+=z-L),w.__size=y,w.__cache={},this}function v(w){const T={boundary:0,storage:0};return typeof w=="number"||typeof w=="boolean"?(T.boundary=4,T.storage=4):w.isVector2?(T.boundary=8,T.storage=8):w.isVector3||w.isColor?(T.boundary=16,T.storage=12):w.isVector4?(T.boundary=16,T.storage=16):w.isMatrix3?(T.boundary=48,T.storage=48):w.isMatrix4?(T.boundary=64,T.storage=64):w.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",w),T}function p(w){const T=w.target;T.removeEventListener("dispose",p);const y=o.indexOf(T.__bindingPointIndex);o.splice(y,1),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function d(){for(const w in s)i.deleteBuffer(s[w]);o=[],s={},r={}}return{bind:l,update:c,dispose:d}}class pA{constructor(e={}){const{canvas:t=nE(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reverseDepthBuffer:f=!1}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;const _=new Uint32Array(4),v=new Int32Array(4);let p=null,d=null;const w=[],T=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=In,this.toneMapping=ts,this.toneMappingExposure=1;const y=this;let z=!1,L=0,D=0,N=null,b=-1,S=null;const R=new Gt,V=new Gt;let I=null;const j=new at(0);let $=0,Q=t.width,J=t.height,ne=1,de=null,he=null;const _e=new Gt(0,0,Q,J),ye=new Gt(0,0,Q,J);let ge=!1;const re=new tu;let ce=!1,ve=!1;const le=new Bt,He=new Bt,Ge=new Y,Fe=new Gt,lt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Ze=!1;function ct(){return N===null?ne:1}let k=n;function Yt(E,F){return t.getContext(E,F)}try{const E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${$c}`),t.addEventListener("webglcontextlost",ae,!1),t.addEventListener("webglcontextrestored",Re,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),k===null){const F="webgl2";if(k=Yt(F,E),k===null)throw Yt(F)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(E){throw console.error("THREE.WebGLRenderer: "+E.message),E}let Qe,tt,We,ht,De,C,M,Z,ee,G,ie,Ee,xe,Ae,je,pe,Me,Oe,Be,we,it,Ye,ft,O;function Se(){Qe=new xT(k),Qe.init(),Ye=new sA(k,Qe),tt=new dT(k,Qe,e,Ye),We=new tA(k,Qe),tt.reverseDepthBuffer&&f&&We.buffers.depth.setReversed(!0),ht=new yT(k),De=new z1,C=new iA(k,Qe,We,De,tt,Ye,ht),M=new mT(y),Z=new vT(y),ee=new CE(k),ft=new hT(k,ee),G=new MT(k,ee,ht,ft),ie=new bT(k,G,ee,ht),Be=new ET(k,tt,C),pe=new pT(De),Ee=new B1(y,M,Z,Qe,tt,ft,pe),xe=new fA(y,De),Ae=new V1,je=new Y1(Qe),Oe=new uT(y,M,Z,We,ie,g,l),Me=new Q1(y,ie,tt),O=new dA(k,ht,tt,We),we=new fT(k,Qe,ht),it=new ST(k,Qe,ht),ht.programs=Ee.programs,y.capabilities=tt,y.extensions=Qe,y.properties=De,y.renderLists=Ae,y.shadowMap=Me,y.state=We,y.info=ht}Se();const se=new uA(y,k);this.xr=se,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){const E=Qe.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){const E=Qe.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return ne},this.setPixelRatio=function(E){E!==void 0&&(ne=E,this.setSize(Q,J,!1))},this.getSize=function(E){return E.set(Q,J)},this.setSize=function(E,F,W=!0){if(se.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}Q=E,J=F,t.width=Math.floor(E*ne),t.height=Math.floor(F*ne),W===!0&&(t.style.width=E+"px",t.style.height=F+"px"),this.setViewport(0,0,E,F)},this.getDrawingBufferSize=function(E){return E.set(Q*ne,J*ne).floor()},this.setDrawingBufferSize=function(E,F,W){Q=E,J=F,ne=W,t.width=Math.floor(E*W),t.height=Math.floor(F*W),this.setViewport(0,0,E,F)},this.getCurrentViewport=function(E){return E.copy(R)},this.getViewport=function(E){return E.copy(_e)},this.setViewport=function(E,F,W,X){E.isVector4?_e.set(E.x,E.y,E.z,E.w):_e.set(E,F,W,X),We.viewport(R.copy(_e).multiplyScalar(ne).round())},this.getScissor=function(E){return E.copy(ye)},this.setScissor=function(E,F,W,X){E.isVector4?ye.set(E.x,E.y,E.z,E.w):ye.set(E,F,W,X),We.scissor(V.copy(ye).multiplyScalar(ne).round())},this.getScissorTest=function(){return ge},this.setScissorTest=function(E){We.setScissorTest(ge=E)},this.setOpaqueSort=function(E){de=E},this.setTransparentSort=function(E){he=E},this.getClearColor=function(E){return E.copy(Oe.getClearColor())},this.setClearColor=function(){Oe.setClearColor.apply(Oe,arguments)},this.getClearAlpha=function(){return Oe.getClearAlpha()},this.setClearAlpha=function(){Oe.setClearAlpha.apply(Oe,arguments)},this.clear=function(E=!0,F=!0,W=!0){let X=0;if(E){let B=!1;if(N!==null){const fe=N.texture.format;B=fe===Zc||fe===jc||fe===Kc}if(B){const fe=N.texture.type,be=fe===Oi||fe===Ds||fe===ro||fe===br||fe===qc||fe===Yc,ke=Oe.getClearColor(),Ue=Oe.getClearAlpha(),$e=ke.r,qe=ke.g,Ie=ke.b;be?(_[0]=$e,_[1]=qe,_[2]=Ie,_[3]=Ue,k.clearBufferuiv(k.COLOR,0,_)):(v[0]=$e,v[1]=qe,v[2]=Ie,v[3]=Ue,k.clearBufferiv(k.COLOR,0,v))}else X|=k.COLOR_BUFFER_BIT}F&&(X|=k.DEPTH_BUFFER_BIT),W&&(X|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k.clear(X)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",ae,!1),t.removeEventListener("webglcontextrestored",Re,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),Ae.dispose(),je.dispose(),De.dispose(),M.dispose(),Z.dispose(),ie.dispose(),ft.dispose(),O.dispose(),Ee.dispose(),se.dispose(),se.removeEventListener("sessionstart",Rn),se.removeEventListener("sessionend",Si),En.stop()};function ae(E){E.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),z=!0}function Re(){console.log("THREE.WebGLRenderer: Context Restored."),z=!1;const E=ht.autoReset,F=Me.enabled,W=Me.autoUpdate,X=Me.needsUpdate,B=Me.type;Se(),ht.autoReset=E,Me.enabled=F,Me.autoUpdate=W,Me.needsUpdate=X,Me.type=B}function Ce(E){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function Je(E){const F=E.target;F.removeEventListener("dispose",Je),Ft(F)}function Ft(E){tn(E),De.remove(E)}function tn(E){const F=De.get(E).programs;F!==void 0&&(F.forEach(function(W){Ee.releaseProgram(W)}),E.isShaderMaterial&&Ee.releaseShaderCache(E))}this.renderBufferDirect=function(E,F,W,X,B,fe){F===null&&(F=lt);const be=B.isMesh&&B.matrixWorld.determinant()<0,ke=Ca(E,F,W,X,B);We.setMaterial(X,be);let Ue=W.index,$e=1;if(X.wireframe===!0){if(Ue=G.getWireframeAttribute(W),Ue===void 0)return;$e=2}const qe=W.drawRange,Ie=W.attributes.position;let rt=qe.start*$e,yt=(qe.start+qe.count)*$e;fe!==null&&(rt=Math.max(rt,fe.start*$e),yt=Math.min(yt,(fe.start+fe.count)*$e)),Ue!==null?(rt=Math.max(rt,0),yt=Math.min(yt,Ue.count)):Ie!=null&&(rt=Math.max(rt,0),yt=Math.min(yt,Ie.count));const wt=yt-rt;if(wt<0||wt===1/0)return;ft.setup(B,X,ke,W,Ue);let nn,ut=we;if(Ue!==null&&(nn=ee.get(Ue),ut=it,ut.setIndex(nn)),B.isMesh)X.wireframe===!0?(We.setLineWidth(X.wireframeLinewidth*ct()),ut.setMode(k.LINES)):ut.setMode(k.TRIANGLES);else if(B.isLine){let ze=X.linewidth;ze===void 0&&(ze=1),We.setLineWidth(ze*ct()),B.isLineSegments?ut.setMode(k.LINES):B.isLineLoop?ut.setMode(k.LINE_LOOP):ut.setMode(k.LINE_STRIP)}else B.isPoints?ut.setMode(k.POINTS):B.isSprite&&ut.setMode(k.TRIANGLES);if(B.isBatchedMesh)if(B._multiDrawInstances!==null)ut.renderMultiDrawInstances(B._multiDrawStarts,B._multiDrawCounts,B._multiDrawCount,B._multiDrawInstances);else if(Qe.get("WEBGL_multi_draw"))ut.renderMultiDraw(B._multiDrawStarts,B._multiDrawCounts,B._multiDrawCount);else{const ze=B._multiDrawStarts,Ot=B._multiDrawCounts,dt=B._multiDrawCount,bn=Ue?ee.get(Ue).bytesPerElement:1,li=De.get(X).currentProgram.getUniforms();for(let hn=0;hn<dt;hn++)li.setValue(k,"_gl_DrawID",hn),ut.render(ze[hn]/bn,Ot[hn])}else if(B.isInstancedMesh)ut.renderInstances(rt,wt,B.count);else if(W.isInstancedBufferGeometry){const ze=W._maxInstanceCount!==void 0?W._maxInstanceCount:1/0,Ot=Math.min(W.instanceCount,ze);ut.renderInstances(rt,wt,Ot)}else ut.render(rt,wt)};function vt(E,F,W){E.transparent===!0&&E.side===Li&&E.forceSinglePass===!1?(E.side=An,E.needsUpdate=!0,Fs(E,F,W),E.side=is,E.needsUpdate=!0,Fs(E,F,W),E.side=Li):Fs(E,F,W)}this.compile=function(E,F,W=null){W===null&&(W=E),d=je.get(W),d.init(F),T.push(d),W.traverseVisible(function(B){B.isLight&&B.layers.test(F.layers)&&(d.pushLight(B),B.castShadow&&d.pushShadow(B))}),E!==W&&E.traverseVisible(function(B){B.isLight&&B.layers.test(F.layers)&&(d.pushLight(B),B.castShadow&&d.pushShadow(B))}),d.setupLights();const X=new Set;return E.traverse(function(B){if(!(B.isMesh||B.isPoints||B.isLine||B.isSprite))return;const fe=B.material;if(fe)if(Array.isArray(fe))for(let be=0;be<fe.length;be++){const ke=fe[be];vt(ke,W,B),X.add(ke)}else vt(fe,W,B),X.add(fe)}),T.pop(),d=null,X},this.compileAsync=function(E,F,W=null){const X=this.compile(E,F,W);return new Promise(B=>{function fe(){if(X.forEach(function(be){De.get(be).currentProgram.isReady()&&X.delete(be)}),X.size===0){B(E);return}setTimeout(fe,10)}Qe.get("KHR_parallel_shader_compile")!==null?fe():setTimeout(fe,10)})};let Kt=null;function Lt(E){Kt&&Kt(E)}function Rn(){En.stop()}function Si(){En.start()}const En=new Xd;En.setAnimationLoop(Lt),typeof self<"u"&&En.setContext(self),this.setAnimationLoop=function(E){Kt=E,se.setAnimationLoop(E),E===null?En.stop():En.start()},se.addEventListener("sessionstart",Rn),se.addEventListener("sessionend",Si),this.render=function(E,F){if(F!==void 0&&F.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(z===!0)return;if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),F.parent===null&&F.matrixWorldAutoUpdate===!0&&F.updateMatrixWorld(),se.enabled===!0&&se.isPresenting===!0&&(se.cameraAutoUpdate===!0&&se.updateCamera(F),F=se.getCamera()),E.isScene===!0&&E.onBeforeRender(y,E,F,N),d=je.get(E,T.length),d.init(F),T.push(d),He.multiplyMatrices(F.projectionMatrix,F.matrixWorldInverse),re.setFromProjectionMatrix(He),ve=this.localClippingEnabled,ce=pe.init(this.clippingPlanes,ve),p=Ae.get(E,w.length),p.init(),w.push(p),se.enabled===!0&&se.isPresenting===!0){const fe=y.xr.getDepthSensingMesh();fe!==null&&un(fe,F,-1/0,y.sortObjects)}un(E,F,0,y.sortObjects),p.finish(),y.sortObjects===!0&&p.sort(de,he),Ze=se.enabled===!1||se.isPresenting===!1||se.hasDepthSensing()===!1,Ze&&Oe.addToRenderList(p,E),this.info.render.frame++,ce===!0&&pe.beginShadows();const W=d.state.shadowsArray;Me.render(W,E,F),ce===!0&&pe.endShadows(),this.info.autoReset===!0&&this.info.reset();const X=p.opaque,B=p.transmissive;if(d.setupLights(),F.isArrayCamera){const fe=F.cameras;if(B.length>0)for(let be=0,ke=fe.length;be<ke;be++){const Ue=fe[be];Ei(X,B,E,Ue)}Ze&&Oe.render(E);for(let be=0,ke=fe.length;be<ke;be++){const Ue=fe[be];yi(p,E,Ue,Ue.viewport)}}else B.length>0&&Ei(X,B,E,F),Ze&&Oe.render(E),yi(p,E,F);N!==null&&(C.updateMultisampleRenderTarget(N),C.updateRenderTargetMipmap(N)),E.isScene===!0&&E.onAfterRender(y,E,F),ft.resetDefaultState(),b=-1,S=null,T.pop(),T.length>0?(d=T[T.length-1],ce===!0&&pe.setGlobalState(y.clippingPlanes,d.state.camera)):d=null,w.pop(),w.length>0?p=w[w.length-1]:p=null};function un(E,F,W,X){if(E.visible===!1)return;if(E.layers.test(F.layers)){if(E.isGroup)W=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(F);else if(E.isLight)d.pushLight(E),E.castShadow&&d.pushShadow(E);else if(E.isSprite){if(!E.frustumCulled||re.intersectsSprite(E)){X&&Fe.setFromMatrixPosition(E.matrixWorld).applyMatrix4(He);const be=ie.update(E),ke=E.material;ke.visible&&p.push(E,be,ke,W,Fe.z,null)}}else if((E.isMesh||E.isLine||E.isPoints)&&(!E.frustumCulled||re.intersectsObject(E))){const be=ie.update(E),ke=E.material;if(X&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Fe.copy(E.boundingSphere.center)):(be.boundingSphere===null&&be.computeBoundingSphere(),Fe.copy(be.boundingSphere.center)),Fe.applyMatrix4(E.matrixWorld).applyMatrix4(He)),Array.isArray(ke)){const Ue=be.groups;for(let $e=0,qe=Ue.length;$e<qe;$e++){const Ie=Ue[$e],rt=ke[Ie.materialIndex];rt&&rt.visible&&p.push(E,be,rt,W,Fe.z,Ie)}}else ke.visible&&p.push(E,be,ke,W,Fe.z,null)}}const fe=E.children;for(let be=0,ke=fe.length;be<ke;be++)un(fe[be],F,W,X)}function yi(E,F,W,X){const B=E.opaque,fe=E.transmissive,be=E.transparent;d.setupLightsView(W),ce===!0&&pe.setGlobalState(y.clippingPlanes,W),X&&We.viewport(R.copy(X)),B.length>0&&rs(B,F,W),fe.length>0&&rs(fe,F,W),be.length>0&&rs(be,F,W),We.buffers.depth.setTest(!0),We.buffers.depth.setMask(!0),We.buffers.color.setMask(!0),We.setPolygonOffset(!1)}function Ei(E,F,W,X){if((W.isScene===!0?W.overrideMaterial:null)!==null)return;d.state.transmissionRenderTarget[X.id]===void 0&&(d.state.transmissionRenderTarget[X.id]=new Ns(1,1,{generateMipmaps:!0,type:Qe.has("EXT_color_buffer_half_float")||Qe.has("EXT_color_buffer_float")?lo:Oi,minFilter:Ts,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:pt.workingColorSpace}));const fe=d.state.transmissionRenderTarget[X.id],be=X.viewport||R;fe.setSize(be.z,be.w);const ke=y.getRenderTarget();y.setRenderTarget(fe),y.getClearColor(j),$=y.getClearAlpha(),$<1&&y.setClearColor(16777215,.5),y.clear(),Ze&&Oe.render(W);const Ue=y.toneMapping;y.toneMapping=ts;const $e=X.viewport;if(X.viewport!==void 0&&(X.viewport=void 0),d.setupLightsView(X),ce===!0&&pe.setGlobalState(y.clippingPlanes,X),rs(E,W,X),C.updateMultisampleRenderTarget(fe),C.updateRenderTargetMipmap(fe),Qe.has("WEBGL_multisampled_render_to_texture")===!1){let qe=!1;for(let Ie=0,rt=F.length;Ie<rt;Ie++){const yt=F[Ie],wt=yt.object,nn=yt.geometry,ut=yt.material,ze=yt.group;if(ut.side===Li&&wt.layers.test(X.layers)){const Ot=ut.side;ut.side=An,ut.needsUpdate=!0,Ur(wt,W,X,nn,ut,ze),ut.side=Ot,ut.needsUpdate=!0,qe=!0}}qe===!0&&(C.updateMultisampleRenderTarget(fe),C.updateRenderTargetMipmap(fe))}y.setRenderTarget(ke),y.setClearColor(j,$),$e!==void 0&&(X.viewport=$e),y.toneMapping=Ue}function rs(E,F,W){const X=F.isScene===!0?F.overrideMaterial:null;for(let B=0,fe=E.length;B<fe;B++){const be=E[B],ke=be.object,Ue=be.geometry,$e=X===null?be.material:X,qe=be.group;ke.layers.test(W.layers)&&Ur(ke,F,W,Ue,$e,qe)}}function Ur(E,F,W,X,B,fe){E.onBeforeRender(y,F,W,X,B,fe),E.modelViewMatrix.multiplyMatrices(W.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),B.onBeforeRender(y,F,W,X,E,fe),B.transparent===!0&&B.side===Li&&B.forceSinglePass===!1?(B.side=An,B.needsUpdate=!0,y.renderBufferDirect(W,F,X,B,E,fe),B.side=is,B.needsUpdate=!0,y.renderBufferDirect(W,F,X,B,E,fe),B.side=Li):y.renderBufferDirect(W,F,X,B,E,fe),E.onAfterRender(y,F,W,X,B,fe)}function Fs(E,F,W){F.isScene!==!0&&(F=lt);const X=De.get(E),B=d.state.lights,fe=d.state.shadowsArray,be=B.state.version,ke=Ee.getParameters(E,B.state,fe,F,W),Ue=Ee.getProgramCacheKey(ke);let $e=X.programs;X.environment=E.isMeshStandardMaterial?F.environment:null,X.fog=F.fog,X.envMap=(E.isMeshStandardMaterial?Z:M).get(E.envMap||X.environment),X.envMapRotation=X.environment!==null&&E.envMap===null?F.environmentRotation:E.envMapRotation,$e===void 0&&(E.addEventListener("dispose",Je),$e=new Map,X.programs=$e);let qe=$e.get(Ue);if(qe!==void 0){if(X.currentProgram===qe&&X.lightsStateVersion===be)return ai(E,ke),qe}else ke.uniforms=Ee.getUniforms(E),E.onBeforeCompile(ke,y),qe=Ee.acquireProgram(ke,Ue),$e.set(Ue,qe),X.uniforms=ke.uniforms;const Ie=X.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Ie.clippingPlanes=pe.uniform),ai(E,ke),X.needsLights=mo(E),X.lightsStateVersion=be,X.needsLights&&(Ie.ambientLightColor.value=B.state.ambient,Ie.lightProbe.value=B.state.probe,Ie.directionalLights.value=B.state.directional,Ie.directionalLightShadows.value=B.state.directionalShadow,Ie.spotLights.value=B.state.spot,Ie.spotLightShadows.value=B.state.spotShadow,Ie.rectAreaLights.value=B.state.rectArea,Ie.ltc_1.value=B.state.rectAreaLTC1,Ie.ltc_2.value=B.state.rectAreaLTC2,Ie.pointLights.value=B.state.point,Ie.pointLightShadows.value=B.state.pointShadow,Ie.hemisphereLights.value=B.state.hemi,Ie.directionalShadowMap.value=B.state.directionalShadowMap,Ie.directionalShadowMatrix.value=B.state.directionalShadowMatrix,Ie.spotShadowMap.value=B.state.spotShadowMap,Ie.spotLightMatrix.value=B.state.spotLightMatrix,Ie.spotLightMap.value=B.state.spotLightMap,Ie.pointShadowMap.value=B.state.pointShadowMap,Ie.pointShadowMatrix.value=B.state.pointShadowMatrix),X.currentProgram=qe,X.uniformsList=null,qe}function po(E){if(E.uniformsList===null){const F=E.currentProgram.getUniforms();E.uniformsList=na.seqWithValue(F.seq,E.uniforms)}return E.uniformsList}function ai(E,F){const W=De.get(E);W.outputColorSpace=F.outputColorSpace,W.batching=F.batching,W.batchingColor=F.batchingColor,W.instancing=F.instancing,W.instancingColor=F.instancingColor,W.instancingMorph=F.instancingMorph,W.skinning=F.skinning,W.morphTargets=F.morphTargets,W.morphNormals=F.morphNormals,W.morphColors=F.morphColors,W.morphTargetsCount=F.morphTargetsCount,W.numClippingPlanes=F.numClippingPlanes,W.numIntersection=F.numClipIntersection,W.vertexAlphas=F.vertexAlphas,W.vertexTangents=F.vertexTangents,W.toneMapping=F.toneMapping}function Ca(E,F,W,X,B){F.isScene!==!0&&(F=lt),C.resetTextureUnits();const fe=F.fog,be=X.isMeshStandardMaterial?F.environment:null,ke=N===null?y.outputColorSpace:N.isXRRenderTarget===!0?N.texture.colorSpace:Pr,Ue=(X.isMeshStandardMaterial?Z:M).get(X.envMap||be),$e=X.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,qe=!!W.attributes.tangent&&(!!X.normalMap||X.anisotropy>0),Ie=!!W.morphAttributes.position,rt=!!W.morphAttributes.normal,yt=!!W.morphAttributes.color;let wt=ts;X.toneMapped&&(N===null||N.isXRRenderTarget===!0)&&(wt=y.toneMapping);const nn=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,ut=nn!==void 0?nn.length:0,ze=De.get(X),Ot=d.state.lights;if(ce===!0&&(ve===!0||E!==S)){const gn=E===S&&X.id===b;pe.setState(X,E,gn)}let dt=!1;X.version===ze.__version?(ze.needsLights&&ze.lightsStateVersion!==Ot.state.version||ze.outputColorSpace!==ke||B.isBatchedMesh&&ze.batching===!1||!B.isBatchedMesh&&ze.batching===!0||B.isBatchedMesh&&ze.batchingColor===!0&&B.colorTexture===null||B.isBatchedMesh&&ze.batchingColor===!1&&B.colorTexture!==null||B.isInstancedMesh&&ze.instancing===!1||!B.isInstancedMesh&&ze.instancing===!0||B.isSkinnedMesh&&ze.skinning===!1||!B.isSkinnedMesh&&ze.skinning===!0||B.isInstancedMesh&&ze.instancingColor===!0&&B.instanceColor===null||B.isInstancedMesh&&ze.instancingColor===!1&&B.instanceColor!==null||B.isInstancedMesh&&ze.instancingMorph===!0&&B.morphTexture===null||B.isInstancedMesh&&ze.instancingMorph===!1&&B.morphTexture!==null||ze.envMap!==Ue||X.fog===!0&&ze.fog!==fe||ze.numClippingPlanes!==void 0&&(ze.numClippingPlanes!==pe.numPlanes||ze.numIntersection!==pe.numIntersection)||ze.vertexAlphas!==$e||ze.vertexTangents!==qe||ze.morphTargets!==Ie||ze.morphNormals!==rt||ze.morphColors!==yt||ze.toneMapping!==wt||ze.morphTargetsCount!==ut)&&(dt=!0):(dt=!0,ze.__version=X.version);let bn=ze.currentProgram;dt===!0&&(bn=Fs(X,F,B));let li=!1,hn=!1,as=!1;const Rt=bn.getUniforms(),kn=ze.uniforms;if(We.useProgram(bn.program)&&(li=!0,hn=!0,as=!0),X.id!==b&&(b=X.id,hn=!0),li||S!==E){We.buffers.depth.getReversed()?(le.copy(E.projectionMatrix),sE(le),rE(le),Rt.setValue(k,"projectionMatrix",le)):Rt.setValue(k,"projectionMatrix",E.projectionMatrix),Rt.setValue(k,"viewMatrix",E.matrixWorldInverse);const ci=Rt.map.cameraPosition;ci!==void 0&&ci.setValue(k,Ge.setFromMatrixPosition(E.matrixWorld)),tt.logarithmicDepthBuffer&&Rt.setValue(k,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(X.isMeshPhongMaterial||X.isMeshToonMaterial||X.isMeshLambertMaterial||X.isMeshBasicMaterial||X.isMeshStandardMaterial||X.isShaderMaterial)&&Rt.setValue(k,"isOrthographic",E.isOrthographicCamera===!0),S!==E&&(S=E,hn=!0,as=!0)}if(B.isSkinnedMesh){Rt.setOptional(k,B,"bindMatrix"),Rt.setOptional(k,B,"bindMatrixInverse");const gn=B.skeleton;gn&&(gn.boneTexture===null&&gn.computeBoneTexture(),Rt.setValue(k,"boneTexture",gn.boneTexture,C))}B.isBatchedMesh&&(Rt.setOptional(k,B,"batchingTexture"),Rt.setValue(k,"batchingTexture",B._matricesTexture,C),Rt.setOptional(k,B,"batchingIdTexture"),Rt.setValue(k,"batchingIdTexture",B._indirectTexture,C),Rt.setOptional(k,B,"batchingColorTexture"),B._colorsTexture!==null&&Rt.setValue(k,"batchingColorTexture",B._colorsTexture,C));const ki=W.morphAttributes;if((ki.position!==void 0||ki.normal!==void 0||ki.color!==void 0)&&Be.update(B,W,bn),(hn||ze.receiveShadow!==B.receiveShadow)&&(ze.receiveShadow=B.receiveShadow,Rt.setValue(k,"receiveShadow",B.receiveShadow)),X.isMeshGouraudMaterial&&X.envMap!==null&&(kn.envMap.value=Ue,kn.flipEnvMap.value=Ue.isCubeTexture&&Ue.isRenderTargetTexture===!1?-1:1),X.isMeshStandardMaterial&&X.envMap===null&&F.environment!==null&&(kn.envMapIntensity.value=F.environmentIntensity),hn&&(Rt.setValue(k,"toneMappingExposure",y.toneMappingExposure),ze.needsLights&&os(kn,as),fe&&X.fog===!0&&xe.refreshFogUniforms(kn,fe),xe.refreshMaterialUniforms(kn,X,ne,J,d.state.transmissionRenderTarget[E.id]),na.upload(k,po(ze),kn,C)),X.isShaderMaterial&&X.uniformsNeedUpdate===!0&&(na.upload(k,po(ze),kn,C),X.uniformsNeedUpdate=!1),X.isSpriteMaterial&&Rt.setValue(k,"center",B.center),Rt.setValue(k,"modelViewMatrix",B.modelViewMatrix),Rt.setValue(k,"normalMatrix",B.normalMatrix),Rt.setValue(k,"modelMatrix",B.matrixWorld),X.isShaderMaterial||X.isRawShaderMaterial){const gn=X.uniformsGroups;for(let ci=0,qn=gn.length;ci<qn;ci++){const Os=gn[ci];O.update(Os,bn),O.bind(Os,bn)}}return bn}function os(E,F){E.ambientLightColor.needsUpdate=F,E.lightProbe.needsUpdate=F,E.directionalLights.needsUpdate=F,E.directionalLightShadows.needsUpdate=F,E.pointLights.needsUpdate=F,E.pointLightShadows.needsUpdate=F,E.spotLights.needsUpdate=F,E.spotLightShadows.needsUpdate=F,E.rectAreaLights.needsUpdate=F,E.hemisphereLights.needsUpdate=F}function mo(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return L},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return N},this.setRenderTargetTextures=function(E,F,W){De.get(E.texture).__webglTexture=F,De.get(E.depthTexture).__webglTexture=W;const X=De.get(E);X.__hasExternalTextures=!0,X.__autoAllocateDepthBuffer=W===void 0,X.__autoAllocateDepthBuffer||Qe.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),X.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(E,F){const W=De.get(E);W.__webglFramebuffer=F,W.__useDefaultFramebuffer=F===void 0},this.setRenderTarget=function(E,F=0,W=0){N=E,L=F,D=W;let X=!0,B=null,fe=!1,be=!1;if(E){const Ue=De.get(E);if(Ue.__useDefaultFramebuffer!==void 0)We.bindFramebuffer(k.FRAMEBUFFER,null),X=!1;else if(Ue.__webglFramebuffer===void 0)C.setupRenderTarget(E);else if(Ue.__hasExternalTextures)C.rebindTextures(E,De.get(E.texture).__webglTexture,De.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){const Ie=E.depthTexture;if(Ue.__boundDepthTexture!==Ie){if(Ie!==null&&De.has(Ie)&&(E.width!==Ie.image.width||E.height!==Ie.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");C.setupDepthRenderbuffer(E)}}const $e=E.texture;($e.isData3DTexture||$e.isDataArrayTexture||$e.isCompressedArrayTexture)&&(be=!0);const qe=De.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(qe[F])?B=qe[F][W]:B=qe[F],fe=!0):E.samples>0&&C.useMultisampledRTT(E)===!1?B=De.get(E).__webglMultisampledFramebuffer:Array.isArray(qe)?B=qe[W]:B=qe,R.copy(E.viewport),V.copy(E.scissor),I=E.scissorTest}else R.copy(_e).multiplyScalar(ne).floor(),V.copy(ye).multiplyScalar(ne).floor(),I=ge;if(We.bindFramebuffer(k.FRAMEBUFFER,B)&&X&&We.drawBuffers(E,B),We.viewport(R),We.scissor(V),We.setScissorTest(I),fe){const Ue=De.get(E.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+F,Ue.__webglTexture,W)}else if(be){const Ue=De.get(E.texture),$e=F||0;k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,Ue.__webglTexture,W||0,$e)}b=-1},this.readRenderTargetPixels=function(E,F,W,X,B,fe,be){if(!(E&&E.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let ke=De.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&be!==void 0&&(ke=ke[be]),ke){We.bindFramebuffer(k.FRAMEBUFFER,ke);try{const Ue=E.texture,$e=Ue.format,qe=Ue.type;if(!tt.textureFormatReadable($e)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!tt.textureTypeReadable(qe)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}F>=0&&F<=E.width-X&&W>=0&&W<=E.height-B&&k.readPixels(F,W,X,B,Ye.convert($e),Ye.convert(qe),fe)}finally{const Ue=N!==null?De.get(N).__webglFramebuffer:null;We.bindFramebuffer(k.FRAMEBUFFER,Ue)}}},this.readRenderTargetPixelsAsync=async function(E,F,W,X,B,fe,be){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let ke=De.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&be!==void 0&&(ke=ke[be]),ke){const Ue=E.texture,$e=Ue.format,qe=Ue.type;if(!tt.textureFormatReadable($e))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!tt.textureTypeReadable(qe))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(F>=0&&F<=E.width-X&&W>=0&&W<=E.height-B){We.bindFramebuffer(k.FRAMEBUFFER,ke);const Ie=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,Ie),k.bufferData(k.PIXEL_PACK_BUFFER,fe.byteLength,k.STREAM_READ),k.readPixels(F,W,X,B,Ye.convert($e),Ye.convert(qe),0);const rt=N!==null?De.get(N).__webglFramebuffer:null;We.bindFramebuffer(k.FRAMEBUFFER,rt);const yt=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await iE(k,yt,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,Ie),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,fe),k.deleteBuffer(Ie),k.deleteSync(yt),fe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(E,F=null,W=0){E.isTexture!==!0&&(Jr("WebGLRenderer: copyFramebufferToTexture function signature has changed."),F=arguments[0]||null,E=arguments[1]);const X=Math.pow(2,-W),B=Math.floor(E.image.width*X),fe=Math.floor(E.image.height*X),be=F!==null?F.x:0,ke=F!==null?F.y:0;C.setTexture2D(E,0),k.copyTexSubImage2D(k.TEXTURE_2D,W,0,0,be,ke,B,fe),We.unbindTexture()},this.copyTextureToTexture=function(E,F,W=null,X=null,B=0){E.isTexture!==!0&&(Jr("WebGLRenderer: copyTextureToTexture function signature has changed."),X=arguments[0]||null,E=arguments[1],F=arguments[2],B=arguments[3]||0,W=null);let fe,be,ke,Ue,$e,qe,Ie,rt,yt;const wt=E.isCompressedTexture?E.mipmaps[B]:E.image;W!==null?(fe=W.max.x-W.min.x,be=W.max.y-W.min.y,ke=W.isBox3?W.max.z-W.min.z:1,Ue=W.min.x,$e=W.min.y,qe=W.isBox3?W.min.z:0):(fe=wt.width,be=wt.height,ke=wt.depth||1,Ue=0,$e=0,qe=0),X!==null?(Ie=X.x,rt=X.y,yt=X.z):(Ie=0,rt=0,yt=0);const nn=Ye.convert(F.format),ut=Ye.convert(F.type);let ze;F.isData3DTexture?(C.setTexture3D(F,0),ze=k.TEXTURE_3D):F.isDataArrayTexture||F.isCompressedArrayTexture?(C.setTexture2DArray(F,0),ze=k.TEXTURE_2D_ARRAY):(C.setTexture2D(F,0),ze=k.TEXTURE_2D),k.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,F.flipY),k.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,F.premultiplyAlpha),k.pixelStorei(k.UNPACK_ALIGNMENT,F.unpackAlignment);const Ot=k.getParameter(k.UNPACK_ROW_LENGTH),dt=k.getParameter(k.UNPACK_IMAGE_HEIGHT),bn=k.getParameter(k.UNPACK_SKIP_PIXELS),li=k.getParameter(k.UNPACK_SKIP_ROWS),hn=k.getParameter(k.UNPACK_SKIP_IMAGES);k.pixelStorei(k.UNPACK_ROW_LENGTH,wt.width),k.pixelStorei(k.UNPACK_IMAGE_HEIGHT,wt.height),k.pixelStorei(k.UNPACK_SKIP_PIXELS,Ue),k.pixelStorei(k.UNPACK_SKIP_ROWS,$e),k.pixelStorei(k.UNPACK_SKIP_IMAGES,qe);const as=E.isDataArrayTexture||E.isData3DTexture,Rt=F.isDataArrayTexture||F.isData3DTexture;if(E.isRenderTargetTexture||E.isDepthTexture){const kn=De.get(E),ki=De.get(F),gn=De.get(kn.__renderTarget),ci=De.get(ki.__renderTarget);We.bindFramebuffer(k.READ_FRAMEBUFFER,gn.__webglFramebuffer),We.bindFramebuffer(k.DRAW_FRAMEBUFFER,ci.__webglFramebuffer);for(let qn=0;qn<ke;qn++)as&&k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,De.get(E).__webglTexture,B,qe+qn),E.isDepthTexture?(Rt&&k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,De.get(F).__webglTexture,B,yt+qn),k.blitFramebuffer(Ue,$e,fe,be,Ie,rt,fe,be,k.DEPTH_BUFFER_BIT,k.NEAREST)):Rt?k.copyTexSubImage3D(ze,B,Ie,rt,yt+qn,Ue,$e,fe,be):k.copyTexSubImage2D(ze,B,Ie,rt,yt+qn,Ue,$e,fe,be);We.bindFramebuffer(k.READ_FRAMEBUFFER,null),We.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else Rt?E.isDataTexture||E.isData3DTexture?k.texSubImage3D(ze,B,Ie,rt,yt,fe,be,ke,nn,ut,wt.data):F.isCompressedArrayTexture?k.compressedTexSubImage3D(ze,B,Ie,rt,yt,fe,be,ke,nn,wt.data):k.texSubImage3D(ze,B,Ie,rt,yt,fe,be,ke,nn,ut,wt):E.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,B,Ie,rt,fe,be,nn,ut,wt.data):E.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,B,Ie,rt,wt.width,wt.height,nn,wt.data):k.texSubImage2D(k.TEXTURE_2D,B,Ie,rt,fe,be,nn,ut,wt);k.pixelStorei(k.UNPACK_ROW_LENGTH,Ot),k.pixelStorei(k.UNPACK_IMAGE_HEIGHT,dt),k.pixelStorei(k.UNPACK_SKIP_PIXELS,bn),k.pixelStorei(k.UNPACK_SKIP_ROWS,li),k.pixelStorei(k.UNPACK_SKIP_IMAGES,hn),B===0&&F.generateMipmaps&&k.generateMipmap(ze),We.unbindTexture()},this.copyTextureToTexture3D=function(E,F,W=null,X=null,B=0){return E.isTexture!==!0&&(Jr("WebGLRenderer: copyTextureToTexture3D function signature has changed."),W=arguments[0]||null,X=arguments[1]||null,E=arguments[2],F=arguments[3],B=arguments[4]||0),Jr('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(E,F,W,X,B)},this.initRenderTarget=function(E){De.get(E).__webglFramebuffer===void 0&&C.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?C.setTextureCube(E,0):E.isData3DTexture?C.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?C.setTexture2DArray(E,0):C.setTexture2D(E,0),We.unbindTexture()},this.resetState=function(){L=0,D=0,N=null,We.reset(),ft.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ni}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;const t=this.getContext();t.drawingBufferColorspace=pt._getDrawingBufferColorSpace(e),t.unpackColorSpace=pt._getUnpackColorSpace()}}class iu{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new at(e),this.near=t,this.far=n}clone(){return new iu(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}}class mA extends Jt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new xi,this.environmentIntensity=1,this.environmentRotation=new xi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){const t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}}class Qd extends Dr{static get type(){return"LineBasicMaterial"}constructor(e){super(),this.isLineBasicMaterial=!0,this.color=new at(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}}const fa=new Y,da=new Y,mf=new Bt,qr=new Jc,qo=new Aa,wl=new Y,gf=new Y;class gA extends Jt{constructor(e=new Mi,t=new Qd){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){const e=this.geometry;if(e.index===null){const t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)fa.fromBufferAttribute(t,s-1),da.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=fa.distanceTo(da);e.setAttribute("lineDistance",new Xn(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){const n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),qo.copy(n.boundingSphere),qo.applyMatrix4(s),qo.radius+=r,e.ray.intersectsSphere(qo)===!1)return;mf.copy(s).invert(),qr.copy(e.ray).applyMatrix4(mf);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;if(h!==null){const g=Math.max(0,o.start),_=Math.min(h.count,o.start+o.count);for(let v=g,p=_-1;v<p;v+=c){const d=h.getX(v),w=h.getX(v+1),T=Yo(this,e,qr,l,d,w);T&&t.push(T)}if(this.isLineLoop){const v=h.getX(_-1),p=h.getX(g),d=Yo(this,e,qr,l,v,p);d&&t.push(d)}}else{const g=Math.max(0,o.start),_=Math.min(f.count,o.start+o.count);for(let v=g,p=_-1;v<p;v+=c){const d=Yo(this,e,qr,l,v,v+1);d&&t.push(d)}if(this.isLineLoop){const v=Yo(this,e,qr,l,_-1,g);v&&t.push(v)}}}updateMorphTargets(){const t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){const s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function Yo(i,e,t,n,s,r){const o=i.geometry.attributes.position;if(fa.fromBufferAttribute(o,s),da.fromBufferAttribute(o,r),t.distanceSqToSegment(fa,da,wl,gf)>n)return;wl.applyMatrix4(i.matrixWorld);const l=e.ray.origin.distanceTo(wl);if(!(l<e.near||l>e.far))return{distance:l,point:gf.clone().applyMatrix4(i.matrixWorld),index:s,face:null,faceIndex:null,barycoord:null,object:i}}class _A extends yn{constructor(e,t,n,s,r,o,a,l,c){super(e,t,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}}class oo extends Mi{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};const c=this;s=Math.floor(s),r=Math.floor(r);const h=[],u=[],f=[],g=[];let _=0;const v=[],p=n/2;let d=0;w(),o===!1&&(e>0&&T(!0),t>0&&T(!1)),this.setIndex(h),this.setAttribute("position",new Xn(u,3)),this.setAttribute("normal",new Xn(f,3)),this.setAttribute("uv",new Xn(g,2));function w(){const y=new Y,z=new Y;let L=0;const D=(t-e)/n;for(let N=0;N<=r;N++){const b=[],S=N/r,R=S*(t-e)+e;for(let V=0;V<=s;V++){const I=V/s,j=I*l+a,$=Math.sin(j),Q=Math.cos(j);z.x=R*$,z.y=-S*n+p,z.z=R*Q,u.push(z.x,z.y,z.z),y.set($,D,Q).normalize(),f.push(y.x,y.y,y.z),g.push(I,1-S),b.push(_++)}v.push(b)}for(let N=0;N<s;N++)for(let b=0;b<r;b++){const S=v[b][N],R=v[b+1][N],V=v[b+1][N+1],I=v[b][N+1];(e>0||b!==0)&&(h.push(S,R,I),L+=3),(t>0||b!==r-1)&&(h.push(R,V,I),L+=3)}c.addGroup(d,L,0),d+=L}function T(y){const z=_,L=new mt,D=new Y;let N=0;const b=y===!0?e:t,S=y===!0?1:-1;for(let V=1;V<=s;V++)u.push(0,p*S,0),f.push(0,S,0),g.push(.5,.5),_++;const R=_;for(let V=0;V<=s;V++){const j=V/s*l+a,$=Math.cos(j),Q=Math.sin(j);D.x=b*Q,D.y=p*S,D.z=b*$,u.push(D.x,D.y,D.z),f.push(0,S,0),L.x=$*.5+.5,L.y=Q*.5*S+.5,g.push(L.x,L.y),_++}for(let V=0;V<s;V++){const I=z+V,j=R+V;y===!0?h.push(j,j+1,I):h.push(j+1,j,I),N+=3}c.addGroup(d,N,y===!0?1:2),d+=N}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new oo(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}}class ep extends Dr{static get type(){return"MeshStandardMaterial"}constructor(e){super(),this.isMeshStandardMaterial=!0,this.defines={STANDARD:""},this.color=new at(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new at(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Id,this.normalScale=new mt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new xi,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}}class su extends Jt{constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new at(e),this.intensity=t}dispose(){}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){const t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,this.groundColor!==void 0&&(t.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(t.object.distance=this.distance),this.angle!==void 0&&(t.object.angle=this.angle),this.decay!==void 0&&(t.object.decay=this.decay),this.penumbra!==void 0&&(t.object.penumbra=this.penumbra),this.shadow!==void 0&&(t.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(t.object.target=this.target.uuid),t}}class vA extends su{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Jt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new at(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}}const Tl=new Bt,_f=new Y,vf=new Y;class xA{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new mt(512,512),this.map=null,this.mapPass=null,this.matrix=new Bt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new tu,this._frameExtents=new mt(1,1),this._viewportCount=1,this._viewports=[new Gt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(e){const t=this.camera,n=this.matrix;_f.setFromMatrixPosition(e.matrixWorld),t.position.copy(_f),vf.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(vf),t.updateMatrixWorld(),Tl.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),this._frustum.setFromProjectionMatrix(Tl),n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(Tl)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.mapSize.copy(e.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const e={};return this.intensity!==1&&(e.intensity=this.intensity),this.bias!==0&&(e.bias=this.bias),this.normalBias!==0&&(e.normalBias=this.normalBias),this.radius!==1&&(e.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(e.mapSize=this.mapSize.toArray()),e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}}class MA extends xA{constructor(){super(new qd(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class SA extends su{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Jt.DEFAULT_UP),this.updateMatrix(),this.target=new Jt,this.shadow=new MA}dispose(){this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}}class yA extends su{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}}const xf=new Bt;class EA{constructor(e,t,n=0,s=1/0){this.ray=new Jc(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new Qc,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,(t.near+t.far)/(t.near-t.far)).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):console.error("THREE.Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return xf.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(xf),this}intersectObject(e,t=!0,n=[]){return Ac(e,this,n,t),n.sort(Mf),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)Ac(e[s],this,n,t);return n.sort(Mf),n}}function Mf(i,e){return i.distance-e.distance}function Ac(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){const r=i.children;for(let o=0,a=r.length;o<a;o++)Ac(r[o],e,t,!0)}}const Sf=new Y;let Ko,Al;class bA extends Jt{constructor(e=new Y(0,0,1),t=new Y(0,0,0),n=1,s=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",Ko===void 0&&(Ko=new Mi,Ko.setAttribute("position",new Xn([0,0,0,0,1,0],3)),Al=new oo(0,.5,1,5,1),Al.translate(0,-.5,0)),this.position.copy(t),this.line=new gA(Ko,new Qd({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new pn(Al,new eu({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,r,o)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{Sf.set(e.z,0,-e.x).normalize();const t=Math.acos(e.y);this.quaternion.setFromAxisAngle(Sf,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:$c}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=$c);function wA(i,e){return-i*e*1.55}const TA=.3,yf=.8;function tp(i){return i.body_height+2*i.wheel_radius}function np(i,e){const t=i/tp(e)*TA*e.weight;return Math.max(-yf*e.weight,Math.min(yf*e.weight,t))}const AA=120,lr=.1,pa=60;class RA{constructor(e,t){this.look=e;const n=(s,r=.7,o=0)=>{const a=new ep({color:s,roughness:r,metalness:o});return t&&(a.color.set(t),a.transparent=!0,a.opacity=.3),a};this.build(n,t===null),this.root.add(this.body,...this.wheels),this.body.position.y=e.wheel_radius,this.root.traverse(s=>{s instanceof pn&&(s.castShadow=t===null,s.receiveShadow=t===null)})}root=new Qi;body=new Qi;wheels=[new Qi,new Qi];x=0;z=0;last=null;build(e,t){const{wheel_radius:n,track:s,body_height:r,body_depth:o}=this.look,a=Math.max(s*.62,.02),l=n*.25,c=(u,f,g,_,v,p,d)=>{const w=new pn(new Us(g,f,u),_);w.position.set(v,p,d),this.body.add(w)},h=e("#e9ebee",.55);if(c(a,r*.94,o,h,0,l+r*.5,0),t){c(s*.8,n*.5,o*.55,e("#3b424a",.6),0,0,0),c(a*.72,r*.26,o*.04,e("#20262c",.25),o*.5,l+r*.72,0),c(a*.62,r*.18,o*.05,e("#b9d8c4",.3),o*.505,l+r*.73,0),c(a*.16,r*.08,o*.08,e("#e07a1f",.5),o*.5,l+r*.42,0);for(const u of[-1,1])c(a*.14,r*.06,o*.07,e("#8b949d",.5),o*.5,l+r*.42,u*a*.22);c(a*1.02,r*.05,o*1.03,e("#0072b2",.5),0,l+r*.12,0)}if(this.look.payload>0&&t){const u=Math.cbrt(this.look.payload/2500);c(u,u,u,e("#8c5a2b",.8),0,this.look.payload_height,0)}this.wheels.forEach((u,f)=>this.tyre(u,f===0?-s/2:s/2,e,t))}tyre(e,t,n,s){const r=this.look.wheel_radius,o=Math.min(this.look.track*.16,r*.7),a=new pn(new oo(r,r,o,40),n("#23272c",.95)),l=new pn(new oo(r*.66,r*.66,o*1.04,32),n("#c9ced3",.45,.1));a.rotation.x=l.rotation.x=Math.PI/2,e.add(a),s&&e.add(l);for(let c=0;s&&c<3;c+=1){const h=new pn(new Us(r*1.2,r*.13,o*1.1),n("#5c656e",.6));h.rotation.z=c*Math.PI/3,e.add(h)}e.position.set(0,r,t)}move(e,t){const{wheel_radius:n,track:s}=this.look,[r,,o,,a]=e;if(this.last!==null){const c=n*(o-this.last);this.x+=c*Math.cos(a),this.z-=c*Math.sin(a)}this.last=o,this.root.rotation.y=a,this.root.position.set(this.x+t*Math.sin(a),0,this.z+t*Math.cos(a)),this.body.rotation.z=-r;const l=s/(2*n)*a;this.wheels[0].rotation.z=-(o-l),this.wheels[1].rotation.z=-(o+l)}shift(e,t){this.x+=e,this.z+=t}start(e){e&&([this.x,this.z,this.last]=[e.x,e.z,e.last])}}function CA(i){const e=document.createElement("canvas");e.width=e.height=128;const t=e.getContext("2d");t.fillStyle=i?"#252b32":"#eeeeec",t.fillRect(0,0,128,128),t.strokeStyle=i?"#39424b":"#cfd1d2",t.lineWidth=2,t.strokeRect(0,0,128,128);const n=new _A(e);return n.wrapS=n.wrapT=ca,n.repeat.set(pa,pa),n.anisotropy=8,n.colorSpace=In,n}class PA{constructor(e,t){this.canvas=e,this.push=t,this.element=e,this.renderer=new pA({canvas:e,antialias:!0}),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=yd,this.floor=new pn(new fo(pa*lr,pa*lr),new ep({roughness:.95})),this.floor.rotation.x=-Math.PI/2,this.floor.receiveShadow=!0,this.sun.castShadow=!0,this.sun.shadow.mapSize.set(1024,1024),this.sun.shadow.radius=6,this.sun.shadow.bias=-5e-4,this.arrow.visible=!1,this.scene.add(this.floor,this.sky,this.sun,this.sun.target,new yA("#ffffff",.35),this.arrow),this.paint(),this.listen()}renderer;scene=new mA;camera=new $n(32,1,.02,30);sun=new SA("#fffdf8",2.4);sky=new vA("#ffffff","#c4c6c8",1.1);floor;figures=[];bodies=[];look=null;arrow=new bA(new Y(1,0,0),new Y,.1,13208064,.03,.02);eye={azimuth:.5,height:.26,away:1};grip=null;turning=null;centre=new Y;calm=matchMedia("(prefers-reduced-motion: reduce)");slow=0;detail=1;seen=-1;stale=!0;element;paint(){const e=document.documentElement.dataset.theme==="dark",t=new at(e?"#1b2026":"#f4f3ef");this.scene.background=t,this.scene.fog=new iu(t,1.2*this.size()+1.2,3*this.size()+2.2),this.floor.material.map=CA(e),this.floor.material.needsUpdate=!0,this.sun.intensity=e?1.7:1.9,this.stale=!0,this.sky.intensity=e?.7:1;const[n,s]=[this.look,this.bodies];n&&this.furnish(n,s)}furnish(e,t){const n=new Map(this.bodies.map((a,l)=>[a,this.figures[l]]));for(const a of this.figures)this.scene.remove(a.root);const s=this.look===null;this.look=e,this.bodies=t,this.seen=-1,this.stale=!0,this.figures=t.map((a,l)=>new RA(e,l?Rs(a):null)),this.figures.forEach((a,l)=>a.start(n.get(t[l])));for(const a of this.figures)this.scene.add(a.root);const r=this.size(),o=r*2.2;Object.assign(this.sun.shadow.camera,{left:-o,right:o,top:o,bottom:-o,near:.01,far:r*12}),this.sun.shadow.camera.updateProjectionMatrix(),s&&this.paint()}size(){return this.look?tp(this.look):.25}move(e){if(!this.look||e.x.length!==this.figures.length||e.n===this.seen)return;this.seen=e.n,this.stale=!0;const t=this.look.track;this.figures.forEach((s,r)=>s.move(e.x[r],wA(r,t)));const n=this.figures[0];if(Math.hypot(n.x,n.z)>3){const s=a=>-Math.round(a/lr)*lr,[r,o]=[s(n.x),s(n.z)];for(const a of this.figures)a.shift(r,o);this.centre.add(new Y(r,0,o))}this.show(e.f[0],e.f[1],e.x[0][0],e.x[0][4])}show(e,t,n,s){const r=this.look,o=this.figures[0].root.position;if(this.arrow.visible=Math.abs(e)>.005,!this.arrow.visible)return;const a=Math.min(.04+Math.abs(e)/r.weight*this.size()*1.2,this.size()*1.6),l=new Y(Math.cos(s),0,-Math.sin(s)).multiplyScalar(Math.sign(e)),c=t*Math.sin(n),h=new Y(o.x+c*Math.cos(s),r.wheel_radius+t*Math.cos(n),o.z-c*Math.sin(s)),u=r.body_depth/2+.004;this.arrow.position.copy(h).addScaledVector(l,-a-u),this.arrow.setDirection(l),this.arrow.setLength(a,a*.32,a*.2)}draw(e){const{clientWidth:t,clientHeight:n}=this.canvas;if(!t||!n)return;this.pace(e);const s=Math.min(devicePixelRatio,2)*this.detail,r=this.renderer.getDrawingBufferSize(new mt);(Math.abs(r.x-t*s)>1||Math.abs(r.y-n*s)>1)&&(this.renderer.setPixelRatio(s),this.renderer.setSize(t,n,!1),this.camera.aspect=t/n,this.camera.updateProjectionMatrix(),this.stale=!0),this.stale&&(this.stale=this.follow(e),this.pull(),this.renderer.render(this.scene,this.camera))}pace(e){this.slow=e>45?this.slow+1:Math.max(0,this.slow-.5),this.slow>40&&this.detail>.6&&(this.detail*=.75,this.slow=0)}follow(e){const t=this.figures[0],n=this.size();t&&this.centre.lerp(new Y(t.x,0,t.z),this.calm.matches?1:1-Math.exp(-e/AA));const s=this.camera.aspect<1?1.25:1,r=n*3.5*this.eye.away*s,{azimuth:o,height:a}=this.eye,l=r*Math.cos(a),c=new Y(this.centre.x,n*.42,this.centre.z);this.camera.position.set(c.x+l*Math.sin(o),c.y+r*Math.sin(a),c.z+l*Math.cos(o)),this.camera.lookAt(c),this.sun.position.set(this.centre.x-n*2,n*5,this.centre.z+n*2.4),this.sun.target.position.copy(this.centre);const h=u=>Math.round(u/lr)*lr;return this.floor.position.set(h(this.centre.x),0,h(this.centre.z)),t?Math.hypot(t.x-this.centre.x,t.z-this.centre.z)>.001:!1}picture(){return this.renderer.render(this.scene,this.camera),new Promise(e=>this.canvas.toBlob(e))}turn(e,t){this.stale=!0,this.eye.azimuth+=e,this.eye.height=Math.min(1.2,Math.max(.03,this.eye.height+t))}zoom(e){this.stale=!0,this.eye.away=Math.min(3,Math.max(.45,this.eye.away*e))}grasp(){const e=this.look;if(!e)return{x:0,y:0};const t=this.figures[0].body.localToWorld(new Y(0,e.body_height*.6,0)).project(this.camera);return{x:(t.x+1)/2*this.canvas.clientWidth,y:(1-t.y)/2*this.canvas.clientHeight}}pointer(e){const t=this.canvas.getBoundingClientRect();return new mt((e.clientX-t.left)/t.width*2-1,1-(e.clientY-t.top)/t.height*2)}ray(e){const t=new EA;return t.setFromCamera(e,this.camera),t}listen(){this.canvas.addEventListener("pointerdown",e=>this.down(e)),this.canvas.addEventListener("pointermove",e=>this.moved(e));for(const e of["pointerup","pointercancel","lostpointercapture"])this.canvas.addEventListener(e,()=>this.up());this.canvas.addEventListener("wheel",e=>{e.preventDefault(),this.zoom(Math.exp(e.deltaY/900))},{passive:!1})}down(e){if(!this.look||!this.figures.length)return;this.canvas.setPointerCapture(e.pointerId);const t=this.pointer(e),n=this.ray(t).intersectObject(this.figures[0].root,!0)[0];if(!n){this.turning={x:e.clientX,y:e.clientY};return}const s=this.figures[0].body.worldToLocal(n.point.clone());this.grip={at:s,mouse:t,height:Math.max(0,s.y)},this.pull(),this.canvas.classList.add("holding")}moved(e){this.turning&&(this.turn((this.turning.x-e.clientX)/160,(e.clientY-this.turning.y)/260),this.turning={x:e.clientX,y:e.clientY}),this.grip&&(this.grip.mouse=this.pointer(e),this.pull())}pull(){const[e,t]=[this.grip,this.look];if(!e||!t)return;const n=this.figures[0],s=n.body.localToWorld(e.at.clone()),r=this.camera.position.clone().sub(s).setY(0).normalize(),o=new Zi().setFromNormalAndCoplanarPoint(r,s),a=this.ray(e.mouse).ray.intersectPlane(o,new Y);if(!a)return;const l=n.root.rotation.y,c=a.sub(s).dot(new Y(Math.cos(l),0,-Math.sin(l)));this.push({force:np(c,t),height:e.height})}up(){this.turning=null,this.grip&&(this.grip=null,this.canvas.classList.remove("holding"),this.push({force:0,height:0}))}}const LA="http://www.w3.org/2000/svg",Yr=170,DA=110;class NA{constructor(e){this.push=e,this.element.addEventListener("pointerdown",t=>this.down(t)),this.element.addEventListener("pointermove",t=>this.moved(t));for(const t of["pointerup","pointercancel"])this.element.addEventListener(t,()=>this.up())}element=Ki("svg",{viewBox:"-200 0 400 200",class:"room flat",role:"img",tabindex:"0"});sides=[];arrow=Ki("path",{class:"arrow"});look=null;grip=null;paint(){}furnish(e,t){this.look=e,this.element.replaceChildren(Ki("line",{x1:-200,x2:200,y1:Yr,y2:Yr,class:"ground"})),this.sides=t.map((n,s)=>this.side(e,n,s>0)).reverse();for(const n of this.sides)this.element.append(n.root);this.sides.reverse(),this.element.append(this.arrow)}scale(e){return DA/(e.body_height+e.wheel_radius)}side(e,t,n){const s=this.scale(e),[r,o,a]=[e.wheel_radius*s,e.body_height*s,e.body_depth*s],l=n?{fill:"none",stroke:Rs(t),"stroke-width":2,opacity:.7}:{},c=Ki("rect",{x:-a/2,y:-o-r*.25,width:a,height:o,rx:3,class:n?"":"shell",...l}),h=Ki("g");h.append(Ki("circle",{r,class:n?"":"tyre",...l}),Ki("path",{d:`M${-r*.6} 0H${r*.6}M0 ${-r*.6}V${r*.6}`,class:n?"":"spokes",...l}));const u=Ki("g");return u.append(c,h),{root:u,body:c,wheel:h}}move(e){const t=this.look;if(!t||e.x.length!==this.sides.length)return;const n=this.scale(t),s=180/Math.PI;this.sides.forEach((u,f)=>{const[g,,_]=e.x[f],v=(_-e.x[0][2])*t.wheel_radius*n;u.root.setAttribute("transform",`translate(${v} ${Yr-t.wheel_radius*n})`),u.body.setAttribute("transform",`rotate(${g*s})`),u.wheel.setAttribute("transform",`rotate(${_*s})`)});const[r,o]=e.f,a=r/t.weight*150,[l,c]=[o*Math.sin(e.x[0][0])*n,Yr-(t.wheel_radius+o*Math.cos(e.x[0][0]))*n],h=Math.sign(r)*7;this.arrow.setAttribute("d",Math.abs(r)>.005?`M${l-a-h} ${c}H${l}m${-h} -5L${l} ${c}l${-h} 5`:"")}draw(){}picture(){return Promise.resolve(new Blob([new XMLSerializer().serializeToString(this.element)],{type:"image/svg+xml"}))}turn(){}zoom(){}grasp(){const e=(this.sides[0]?.body??this.element).getBoundingClientRect(),t=this.element.getBoundingClientRect();return{x:e.x-t.x+e.width/2,y:e.y-t.y+e.height*.4}}down(e){const t=this.sides[0];if(!this.look||!t?.root.contains(e.target))return;this.element.setPointerCapture(e.pointerId);const n=this.element.getBoundingClientRect().height/200,s=this.element.getBoundingClientRect().y+(Yr-this.look.wheel_radius*this.scale(this.look))*n;this.grip={x:e.clientX,height:Math.max(0,(s-e.clientY)/n/this.scale(this.look))},this.push({force:0,height:this.grip.height})}moved(e){if(!this.grip||!this.look)return;const t=this.scale(this.look)*this.element.getBoundingClientRect().height/200;this.push({force:np((e.clientX-this.grip.x)/t,this.look),height:this.grip.height})}up(){this.grip&&(this.grip=null,this.push({force:0,height:0}))}}function Ki(i,e={}){const t=document.createElementNS(LA,i);for(const[n,s]of Object.entries(e))s!==""&&t.setAttribute(n,String(s));return t}const Ef=.25,bf=1.5,UA=.12,IA=.15;class FA{held=new Set;last="";asked=0;padded=!1;constructor(){window.addEventListener("keydown",e=>this.down(e)),window.addEventListener("keyup",e=>this.up(e)),window.addEventListener("blur",()=>this.release())}down(e){const t=e.target;e.repeat||e.ctrlKey||e.metaKey||e.altKey||/^(INPUT|SELECT|TEXTAREA)$/.test(t.tagName)||t.getAttribute("role")==="tab"||t.closest("dialog")||/^(Arrow(Up|Down|Left|Right)|f|b)$/.test(e.key)&&(e.preventDefault(),this.held.add(e.key),this.push(),this.steer(...this.keys()))}up(e){this.held.delete(e.key)&&(this.push(),this.steer(...this.keys()))}release(){this.held.size&&(this.held.clear(),this.push(),this.steer(0,0))}keys(){const e=t=>this.held.has(t)?1:0;return[Ef*(e("ArrowUp")-e("ArrowDown")),bf*(e("ArrowLeft")-e("ArrowRight"))]}pushing=!1;push(){const e=(this.held.has("b")?1:0)-(this.held.has("f")?1:0);if(!e&&!this.pushing)return;this.pushing=e!==0;const t=te.changed?.look;te.send({kind:"Drag",force:e*UA*(t?.weight??6),height:t?.com_height??.07})}steer(e,t){const n=`${e.toFixed(2)} ${t.toFixed(2)}`;n!==this.last&&(this.last=n,te.send({kind:"Steer",speed:e,rate:t}))}tick(e){if(e-this.asked<60)return;this.asked=e;const t=navigator.getGamepads?.().find(s=>s?.connected);if(this.held.size||!t&&!this.padded)return;this.padded=!!t;const n=s=>{const r=t?.axes[s]??0;return Math.abs(r)<IA?0:-r};this.steer(Ef*n(1),bf*n(0))}}const wf="http://www.w3.org/2000/svg";function Tf(i){const e=i.board?.students??[],t=[];i.role==="teacher"&&(t.push(H("div",{className:"row"},bt(q("broadcast"),()=>i.send({kind:"Broadcast",setup:i.setup}),{className:"main","data-key":"broadcast"}))),t.push(H("div",{className:"wall"},...e.map(OA))));const n=H("thead",{},H("tr",{},...["",q("name"),q("bestPush"),q("effort"),q("family")].map(r=>H("th",{scope:"col"},r)))),s=e.map((r,o)=>H("tr",{className:r.here?"":"away"},H("td",{},String(o+1)),H("td",{},r.name),H("td",{},r.best.toFixed(3)),H("td",{},r.effort.toFixed(0)),H("td",{},oi(r.controller).split(":")[0])));return t.push(H("div",{className:"table"},H("table",{className:"board","aria-label":q("board")},n,H("tbody",{},...s)))),[H("div",{className:"column wide"},...t)]}function OA(i){const e=document.createElementNS(wf,"svg");e.setAttribute("viewBox","-30 -48 60 60"),e.setAttribute("aria-hidden","true");const t=(s,r)=>{const o=document.createElementNS(wf,s);for(const[a,l]of Object.entries(r))o.setAttribute(a,l);e.append(o)},n=(i.pitch*180/Math.PI).toFixed(1);return t("rect",{x:"-6",y:"-40",width:"12",height:"38",rx:"3",class:"stick",transform:`rotate(${n})`}),t("circle",{r:"8",cx:"0",cy:"0",class:"wheel"}),t("line",{x1:"-30",x2:"30",y1:"8.5",y2:"8.5",class:"ground"}),H("figure",{className:`tile${i.fallen?" down":""}${i.here?"":" away"}`},e,H("figcaption",{},i.name))}const _s=["twin","nonlinear","linear"],Rl=[{setup:{controller:"off",bodies:_s},lean:.02},{setup:{controller:"off",kit:"ideal",bodies:["nonlinear","linear"]},lean:.03},{setup:{controller:"lqr",bodies:_s},lean:.1},{setup:{controller:"lqg",bodies:_s},lean:0,strike:"front"},{setup:{controller:"lqg",bodies:_s},lean:0,strike:"back"},{setup:{controller:"lqg",bodies:_s},lean:0,strike:"front"},{setup:{controller:"lqr",bodies:_s,payload:.12,payload_height:.2},lean:0},{setup:{controller:"robust",bodies:_s,payload:.12,payload_height:.2},lean:0}];class kA{root=H("div",{className:"panel-body tour"});at=0;build(){const e=gd().tour[this.at],t=(n,s)=>H("div",{className:"hint-part"},H("h4",{},n),H("p",{},s));St(this.root,H("div",{className:"column wide"},H("p",{className:"note"},q("tourStep",{n:this.at+1})),H("h3",{},e.title),H("div",{className:"hints"},t(q("tourDo"),e.do),t(q("tourWatch"),e.watch),t(q("tourAsk"),e.ask)),H("div",{className:"row"},bt(q("previous"),()=>this.move(-1,"previous"),{disabled:this.at===0,"data-key":"tour-previous"}),bt(q("tourSet"),()=>this.set(),{className:"main","data-key":"tour-set"}),bt(q("next"),()=>this.move(1,"next"),{disabled:this.at===Rl.length-1,"data-key":"tour-next"}))))}move(e,t="set"){this.at=Math.min(Math.max(this.at+e,0),Rl.length-1),this.build();const n=s=>this.root.querySelector(`[data-key=tour-${s}]:enabled`);(n(t)??n("set"))?.focus()}set(){const{setup:e,lean:t,strike:n}=Rl[this.at];te.change({...Ea,...e}),te.send({kind:"Play",paused:!1,speed:1}),te.send({kind:"StandUp",pitch:t}),n&&window.setTimeout(()=>te.send({kind:"Strike",what:n,size:n==="front"?.1:-.12}),1e3)}}const Cl=["Controller","Robot","Kit","See","Identify","Keep","Tour","Class"];class BA{constructor(e){this.app=e,this.theme(localStorage.getItem("theme")??""),fh(localStorage.getItem("language")??(navigator.language.startsWith("es")?"es":"en")),te.listen(t=>this.hear(t)),this.scrub.addEventListener("input",()=>te.send({kind:"Scrub",back:-Number(this.scrub.value)})),this.room.element.addEventListener("keydown",t=>this.look(t)),window.addEventListener("keydown",t=>this.key(t)),this.begin()}room=this.furnish();charts=new XS(()=>this.seconds);see=new iy;controller=new cy;robot=new uy;kit=new hy;identify=new dy;keep=new py(()=>this.room.picture());tour=new kA;classRoot=H("div",{className:"panel-body"});tab="Controller";seconds=10;knock=.05;speed=1;scrub=H("input",{type:"range",min:"-60",max:"0",step:"0.02",value:"0",className:"scrub","data-key":"scrub"});pauseButton=H("button",{type:"button","data-key":"pause"});status=H("span",{className:"status",role:"status"});light=H("span",{className:"headlight"});force=H("div",{className:"force","aria-hidden":"true"});fell=H("div",{className:"fell",role:"status"});toasts=H("div",{className:"toasts",role:"log","aria-live":"polite"});spoken=H("p",{className:"hidden","aria-live":"off"});tabs=H("div",{className:"tabs",role:"tablist"});panel=H("div",{className:"panel",role:"tabpanel",tabIndex:-1,id:"panel"});clock=H("span",{className:"clock"});state="connecting";drawn=0;drawnFirst=!1;plotted=0;said=0;shape="";steering=new FA;begin(){const e=mh.inPage(),t=KS(location.hash)||(sessionStorage.getItem("token")??"");t&&sessionStorage.setItem("token",t),location.hash.includes("token=")&&history.replaceState(null,"",location.pathname),this.build(),e?(this.says("replaying"),new mh(e),document.body.classList.add("replay")):t&&!sessionStorage.getItem("name")&&t.length<12?this.join(t):this.connect(t,sessionStorage.getItem("name")??""),requestAnimationFrame(n=>this.frame(n))}connect(e,t){new jS({token:e,name:t},(n,s)=>this.says(n,s))}join(e){const t=H("input",{type:"text",id:"name",maxLength:40,required:!0,autocomplete:"name"}),n=H("dialog",{className:"join","aria-label":q("joinTitle")},H("form",{method:"dialog",onsubmit:s=>{s.preventDefault(),t.value.trim()&&(sessionStorage.setItem("name",t.value.trim()),n.remove(),this.connect(e,t.value.trim()))}},H("h2",{},q("joinTitle")),H("label",{for:"name"},q("yourName")),t,H("button",{className:"main"},q("enter"))));this.app.append(n),n.showModal()}build(){this.room.element.setAttribute("aria-label",q("scene")),this.scrub.setAttribute("aria-label",q("back"));const e=Object.entries(aa).map(([s,r])=>[s,r.language]),t=H("header",{},H("a",{className:"skip",href:"#panel",onclick:()=>this.panel.focus()},q("skip")),H("h1",{},H("span",{className:"mark","aria-hidden":"true"}),q("title")),this.light,H("span",{className:"grow"}),this.clock,this.status,Ls("",e,md(),s=>this.speak(s),"language"),bt("◐",()=>this.theme(document.documentElement.dataset.theme==="dark"?"light":"dark"),{"aria-label":q("theme"),title:q("theme"),"data-key":"theme"}),bt("?",()=>this.help(),{"aria-label":q("help"),title:q("help"),"data-key":"help"}));t.querySelector("select")?.setAttribute("aria-label","Language / Idioma");const n=H("section",{className:"scene","aria-label":q("scene")},this.room.element,this.force,this.fell,H("p",{className:"hint"},q("hint")),this.transport(),this.pushes());St(this.app,t,H("main",{},n,this.charts.root,this.panels()),this.toasts,this.spoken),this.lamp(),te.changed&&this.rebuild()}furnish(){const e=dd(33,s=>te.send({kind:"Drag",force:s.force,height:s.height})),t=H("canvas",{className:"room",tabIndex:0,role:"img"}),n=document.createElement("canvas").getContext("webgl2");return n?.getExtension("WEBGL_lose_context")?.loseContext(),n?new PA(t,e):new NA(e)}transport(){this.pauseButton.onclick=()=>this.pause();const e=[["0.05","1/20"],["0.1","1/10"],["0.25","1/4"],["0.5","1/2"],["1","1"]],t=Ls(q("speed"),e,String(this.speed),s=>{this.speed=Number(s),te.send({kind:"Play",paused:te.snapshot?.paused??!1,speed:this.speed})},"speed"),n=bt(q("step"),()=>te.send({kind:"Step",periods:1}),{"data-key":"step"});return H("div",{className:"transport"},this.pauseButton,n,t,H("label",{className:"scrubbing"},H("span",{},q("back")),this.scrub))}pushes(){const e=(s,r)=>()=>te.send({kind:"Strike",what:s,size:r}),t=()=>te.changed?.look.weight??6,n=ii(q("size"),{low:.01,high:.5,log:!0,show:s=>q("newtons",{force:`${s.toFixed(2)}`})+" s",key:"knock"},s=>this.knock=s);return n.set(this.knock),H("div",{className:"pushes",role:"group","aria-label":q("pushes")},bt(q("front"),e("front",.1),{title:q("frontTip"),"data-key":"front"}),bt(q("backPush"),e("back",-.12),{title:q("backTip"),"data-key":"back"}),bt(q("impulse"),()=>e("impulse",this.knock)(),{"data-key":"impulse"}),n.root,bt(q("pullLeft"),()=>e("pull_left",.25*t())(),{"data-key":"pull_left"}),bt(q("pullRight"),()=>e("pull_right",.25*t())(),{"data-key":"pull_right"}),bt(q("tilt"),()=>te.send({kind:"StandUp",pitch:.1}),{"data-key":"tilt"}),bt(q("standUp"),()=>this.stand(),{"data-key":"stand",className:"main"}))}panels(){const e=Cl.filter(n=>n!=="Class"||te.role!=="alone"),t={Controller:q("tabController"),Robot:q("tabRobot"),Kit:q("tabKit"),See:q("tabSee"),Identify:q("tabIdentify"),Keep:q("tabKeep"),Tour:q("tabTour"),Class:q("tabClass")};return this.tabs.setAttribute("aria-label",q("tabs")),St(this.tabs,...e.map(n=>bt(t[n],()=>this.open(n),{role:"tab",id:`tab-${n}`,"aria-selected":String(n===this.tab),"aria-controls":"panel",tabIndex:n===this.tab?0:-1,"data-key":`tab-${n}`,onkeydown:s=>this.along(s,e,n)}))),H("section",{className:"below"},this.tabs,this.panel)}along(e,t,n){const s={ArrowRight:1,ArrowLeft:-1}[e.key];if(!s)return;e.preventDefault(),e.stopPropagation();const r=t[(t.indexOf(n)+s+t.length)%t.length];this.open(r),document.getElementById(`tab-${r}`)?.focus()}open(e){this.tab=e;for(const t of this.tabs.querySelectorAll("[role=tab]")){const n=t.id===`tab-${e}`;t.setAttribute("aria-selected",String(n)),t.tabIndex=n?0:-1}this.panel.setAttribute("aria-labelledby",`tab-${e}`),this.fill()}fill(){if(!te.catalogue||!te.changed)return;this.tab==="Class"&&St(this.classRoot,...Tf(te));const e={Controller:this.controller,Robot:this.robot,Kit:this.kit,See:this.see,Identify:this.identify,Keep:this.keep,Tour:this.tour}[this.tab];e?.build(),St(this.panel,e?.root??this.classRoot)}rebuild(){this.shape="",this.follow(),this.fill(),this.lamp()}follow(){const e=te.changed;if(!e)return;const t=JSON.stringify([e.bodies,e.look]);t!==this.shape&&(this.shape=t,this.room.furnish(e.look,e.bodies),this.charts.build())}hear(e){switch(e.kind){case"Welcome":this.build();break;case"Catalogue":this.fill();break;case"Changed":{const t=!this.panel.firstChild;this.follow(),t?this.fill():this.update();break}case"Analysed":case"Light":this.lamp(),this.update();break;case"Equations":this.tab==="See"&&this.see.show();break;case"Snapshot":this.transported();break;case"Progress":this.identify.progress(e.job,e.fraction),e.job==="certify"&&this.busy(e.fraction<1);break;case"JobResult":this.identify.found(),this.toast(e.title,e.ok?"info":"error"),ys&&this.tab==="Identify"&&this.identify.build();break;case"Made":this.keep.made(e.name,e.url.startsWith("blob:")?e.url:te.files+e.url),this.toast(q("made",{name:e.name}),"info");break;case"Notice":this.toast(e.key?oi(e.key):e.text,e.level);break;case"Recovered":this.recovered(e.impulse,e.best,e.fell);break;case"Board":this.tab==="Class"&&St(this.classRoot,...Tf(te));break}}update(){this.tab==="See"&&this.see.show(),{Controller:this.controller,Robot:this.robot,Kit:this.kit}[this.tab]?.update()}lamp(){const e=te.lit?.light??"none";St(this.light,H("span",{className:`lamp ${e}`,"aria-hidden":"true"}),H("span",{},xd()[1].textContent??""))}busy(e){this.panel.querySelector("[data-key=certify]")?.toggleAttribute("aria-busy",e)}recovered(e,t,n){const s={impulse:e.toFixed(3),best:t.toFixed(3)};this.toast(q(n?"lostPush":"recovered",s),"info")}transported(){const e=te.snapshot;if(!e)return;const t=e.paused?q("play"):q("pause");this.pauseButton.textContent!==t&&(this.pauseButton.textContent=t),document.activeElement!==this.scrub&&(this.scrub.value=String(-e.back)),this.clock.textContent=`${e.t.toFixed(1)} s`;const n=!!e.x[0][8];n!==!!this.fell.textContent&&St(this.fell,...n?[H("span",{},q("fallen")+" "),bt(q("standUp"),()=>this.stand(),{className:"main"})]:[]);const s=e.f[0];this.force.textContent=Math.abs(s)>.005?q("newtons",{force:s.toFixed(2).replace("-","−")}):""}stand(){te.send({kind:"StandUp",pitch:0}),te.send({kind:"Play",paused:!1,speed:this.speed})}pause(){te.send({kind:"Play",paused:!te.snapshot?.paused,speed:this.speed})}says(e,t=""){this.state=e;const n={connecting:q("connecting"),connected:q("connected"),lost:q("lost"),refused:q("refused"),replaying:q("replaying")};this.status.className=`status ${e}`,this.status.textContent=n[e],e==="refused"&&(sessionStorage.removeItem("name"),St(this.app,H("main",{className:"refused",role:"alert"},H("h1",{},q("refused")),H("p",{},t),bt("↻",()=>location.reload()))))}toast(e,t){const n=H("div",{className:`toast ${t}`},H("span",{},e),bt("×",()=>n.remove(),{"aria-label":q("close")}));for(this.toasts.append(n);this.toasts.children.length>3;)this.toasts.firstElementChild?.remove();window.setTimeout(()=>n.remove(),t==="error"?15e3:6e3)}speak(e){fh(e),localStorage.setItem("language",e),this.build(),this.says(this.state),this.fell.replaceChildren(),this.app.querySelector("[data-key=language]")?.focus()}theme(e){const t=e?e==="dark":matchMedia("(prefers-color-scheme: dark)").matches;document.documentElement.dataset.theme=t?"dark":"light",e&&localStorage.setItem("theme",e),this.room.paint(),te.changed&&this.charts.build(),this.panel.firstChild&&this.fill()}help(){const e=gd().keys.map(([n,s])=>H("tr",{},H("th",{scope:"row"},n),H("td",{},s))),t=H("dialog",{className:"help","aria-label":q("help"),onclose:()=>t.remove()},H("h2",{},q("help")),H("table",{},H("tbody",{},...e)),bt(q("close"),()=>t.close(),{className:"main"}));this.app.append(t),t.showModal()}key(e){const t=e.target;if(!(e.ctrlKey||e.metaKey||e.altKey||/^(INPUT|SELECT|TEXTAREA|DIALOG)$/.test(t.tagName))&&!(e.key===" "&&t.tagName==="BUTTON")){if(e.key==="?")this.help();else if(e.key===" ")this.pause();else if(e.key===".")te.send({kind:"Step",periods:1});else if(e.key===","||e.key==="/")te.send({kind:"Scrub",back:Math.max(0,Math.min(60,(te.snapshot?.back??0)+(e.key===","?.25:-.25)))});else if(e.key==="s")this.stand();else if(e.key==="n"||e.key==="p")this.toured(e.key==="n"?1:-1);else if(e.key==="k")te.send({kind:"Strike",what:"impulse",size:this.knock});else if(/^[1-8]$/.test(e.key)&&document.getElementById(`tab-${Cl[Number(e.key)-1]}`))this.open(Cl[Number(e.key)-1]);else return;e.preventDefault()}}toured(e){const t=this.tab==="Tour";t||this.open("Tour"),this.tour.move(t?e:0)}look(e){const t={"[":[-.15,0],"]":[.15,0],"{":[0,-.1],"}":[0,.1]};e.key in t&&this.room.turn(...t[e.key]),e.key==="+"&&this.room.zoom(.9),e.key==="-"&&this.room.zoom(1.1)}frame(e){te.snapshot&&this.room.move(te.snapshot),this.room.draw(e-this.drawn),this.drawnFirst||=te.snapshot!==null,this.drawn=e,e-this.plotted>45&&(this.charts.draw(),this.tab==="See"&&this.see.draw(),this.plotted=e),e-this.said>2e3&&(this.describe(),this.said=e),this.steering.tick(e),requestAnimationFrame(t=>this.frame(t))}describe(){const[e,t]=[te.snapshot,te.changed];if(!e||!t)return;const n=oi(t.bodies[0]),s=(t.look.wheel_radius*e.x[0][2]*100).toFixed(0),r=e.x[0][8]?q("fellNow",{body:n}):q("sceneNow",{body:n,pitch:(e.x[0][0]*180/Math.PI).toFixed(1),way:s});this.spoken.textContent=r,this.room.element.setAttribute("aria-label",`${q("scene")} ${r}`)}picture(){return this.room.picture()}grasp(){return this.room.grasp()}}const zA=new BA(document.getElementById("app"));Object.assign(window,{upright:{store:te,page:zA}});
